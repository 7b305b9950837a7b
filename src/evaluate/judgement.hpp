// Findings held against what is really there.
#pragma once

#include <string>
#include <vector>

#include "depth/depth_statistics.hpp"
#include "detect/findings.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// One piece of debris, as the camera sees it.
struct Target {
  std::string kind;
  int visible_px = 0;
  double unhidden_px = 0.0;           ///< how many there would be if nothing lay before it
  double distance_m = 0.0;            ///< mean depth of its visible pixels
  std::vector<std::uint32_t> pixels;  ///< visible, by position in the rows laid end to end
  int shown_px = 0;                   ///< pixels of the depth image that it changes, see count_shown()

  /// At least half of it lies open to the camera, which has a pixel for it.
  [[nodiscard]] bool is_visible() const { return visible_px > 0 && 2.0 * visible_px >= unhidden_px; }
  /// It leaves a trace in depth that is as large as what a dot of the projector spoils: a quarter of a
  /// matcher's window of 9 x 9. Between the dots lie things without any.
  [[nodiscard]] bool is_shown() const { return shown_px >= 20; }
};

/// All debris of the camera's scene of which a pixel is visible.
[[nodiscard]] std::vector<Target> visible_targets(const SimulatedCamera& camera);

/// What changed besides debris. Pixels by position in the rows laid end to end.
struct OtherChanges {
  std::vector<std::uint32_t> work;    ///< planned: what was installed, and where what is gone was
  std::vector<std::uint32_t> traces;  ///< dust, smears and fingerprints that change the light by a hundredth
};

/// @param before, after cameras at one place, of scenes whose objects have the same names
[[nodiscard]] OtherChanges other_changes(const SimulatedCamera& before, const SimulatedCamera& after);

/// Counts for each target the pixels, within 4 of its own, whose disparity it changes by more than 0.1 px or
/// whose depth it brings or takes: a trace of three deviations of the noise that one capture has and another
/// has not, as faithfulness measures it (docs/simulator.md).
/// @param without, with two captures of one place with the very same noise, without debris and with it
/// @param disparity_by_depth focal length times baseline: disparity in pixels times depth in depth units
void count_shown(const DepthStatistics& without, const DepthStatistics& with, double disparity_by_depth,
                 std::vector<Target>& targets);

struct Judgement {
  std::vector<bool> found;  ///< of each target
  std::size_t false_findings = 0;
  std::size_t work_findings = 0;   ///< of planned work: true changes, but no debris
  std::size_t trace_findings = 0;  ///< of dust, smears and fingerprints
};

/// A finding points at debris when at least half of its pixels lie within 15 pixels of a target: there may be
/// the target's shadow, or what it hides of the place before. One that lies so beside planned work, or on
/// traces, is counted apart; any other finding is false. A target is found
/// when a finding that points at debris has a pixel within 4 pixels of it: half of the matcher's window, by
/// which it blurs what it shows.
[[nodiscard]] Judgement judge(const std::vector<Finding>& findings, const std::vector<Target>& targets,
                              int width, int height, const OtherChanges& others = {});

}  // namespace rva
