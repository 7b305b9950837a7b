// Comparison of findings with the truth.
#pragma once

#include <string>
#include <vector>

#include "depth/depth_statistics.hpp"
#include "detect/findings/findings.hpp"
#include "geometry/stereo_scale.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// One piece of debris in the view of a camera.
struct Target {
  std::string kind;                   ///< name in the catalogue of debris
  int visible_px = 0;                 ///< number of pixels in which it is the nearest surface
  double unhidden_px = 0.0;           ///< number of visible pixels if nothing occluded it
  double distance_m = 0.0;            ///< mean depth of its visible pixels
  std::vector<std::uint32_t> pixels;  ///< visible pixels, as row-major indices
  int shown_px = 0;                   ///< pixels of the depth image that it changes, see count_shown()

  /// Whether at least half of it is visible, and at least one pixel.
  [[nodiscard]] bool is_visible() const { return visible_px > 0 && 2.0 * visible_px >= unhidden_px; }
  /// Whether it changes the depth image at least as much as one dot of the projector affects: a quarter of a
  /// matcher's window of 9 x 9 pixels. Debris between the dots may not change it at all.
  [[nodiscard]] bool is_shown() const { return shown_px >= 20; }
};

/// All debris of the camera's scene with at least one visible pixel.
[[nodiscard]] std::vector<Target> visible_targets(const SimulatedCamera& camera);

/// Changes other than debris. Pixels are row-major indices.
struct OtherChanges {
  std::vector<std::uint32_t> work;    ///< planned work: objects that were installed or removed
  std::vector<std::uint32_t> traces;  ///< dust, smears and fingerprints that change light by more than 1 %
};

/// The pixels of planned work and of traces.
/// @param before, after cameras with the same pose; objects present in both scenes have the same name in both
[[nodiscard]] OtherChanges other_changes(const SimulatedCamera& before, const SimulatedCamera& after);

/// Counts for each target the pixels within 4 pixels of it at which it changes disparity by more than 0.1 px,
/// or adds or removes a measurement. The threshold is three standard deviations of the noise that differs
/// between two captures, as measured by script/faithfulness (docs/simulator.md).
/// @param without, with captures of one view with identical noise, without debris and with it
void count_shown(const DepthStatistics& without, const DepthStatistics& with, const StereoScale& stereo,
                 std::vector<Target>& targets);

/// Findings compared with the truth.
struct Judgement {
  std::vector<bool> found;         ///< for each target
  std::size_t false_findings = 0;  ///< findings far from debris, planned work and traces
  std::size_t work_findings = 0;   ///< of planned work: true changes, but not debris
  std::size_t trace_findings = 0;  ///< of dust, smears and fingerprints
};

/// Pixels that are no farther than this from a target are near it: a margin for the target's shadow and for
/// the background that it occludes.
inline constexpr int near_target_px = 15;
/// A finding that is no farther than this from a target has found it: half of the matcher's window, by which
/// the matcher blurs the depth image.
inline constexpr int found_within_px = 4;

/// Assigns findings to their causes. A finding is attributed to debris if at least half of its pixels lie
/// within near_target_px of a target. A finding that is likewise near planned work or traces is counted
/// separately; any other finding is false. A target is found if a finding attributed to debris has a pixel
/// within found_within_px of it.
[[nodiscard]] Judgement judge(const std::vector<Finding>& findings, const std::vector<Target>& targets,
                              int width, int height, const OtherChanges& others = {});

}  // namespace rva
