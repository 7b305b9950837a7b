// How reliably change is found where the camera was moved, or came back: many simulated inspections.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "core/progress.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "evaluate/moved_targets.hpp"
#include "evaluate/moved_wing.hpp"
#include "map/pose_return.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// Options of a study of cameras that were moved.
struct MovedStudyOptions {
  CameraReturn how = CameraReturn::elsewhere;  ///< how the camera returned after the work
  int inspections = 20;                        ///< number of inspections
  std::uint64_t first_seed = 1;                ///< seed of the first inspection; the others follow it
  std::vector<int> captures{1, 4, 8};          ///< a side, dithered; ascending
  std::vector<double> allowed{CalibratedOptions{}.false_findings};  ///< false findings; ascending
  int frames = 10;                                                  ///< of each capture
  bool octree = false;              ///< the thesis' pipeline too, on one frame a side: a minute each time
  bool lamp = false;                ///< images under the camera's lamp, too
  bool color = false;               ///< colour images, too
  PoseReturnOptions pose_return{};  ///< of a robot that stayed, as `rva serve` has it
  BayFeatures bay;                  ///< features of the random wings
  /// Gives the camera of an inspection by the inspection's seed. All sides of one inspection have the same.
  std::function<StereoSensorOptions(std::uint64_t seed)> sensor{
      [](std::uint64_t) { return StereoSensorOptions{}; }};
};

/// How the views of one inspection were registered.
struct MovedRegistration {
  std::string method;      ///< as of MovedResult
  int captures = 1;        ///< captures per side
  double error_mm = 0.0;   ///< 0 where it was refused
  double error_deg = 0.0;  ///< likewise
  std::string doubt;       ///< why it was refused; empty where it was trusted
  /// Square of the error in deviations of the stated covariance: chi-squared with six degrees of freedom
  /// where it states what it should. Empty where none is stated.
  std::optional<double> normalised{};
};

/// One setting with so many captures a side.
struct MovedResult {
  std::string method;                 ///< "auto", "octree"
  int captures = 1;                   ///< captures per side
  double setting = 0.0;               ///< false findings allowed; edge of a cell, in metres
  std::size_t false_when_clean = 0;   ///< findings where nothing changed
  std::size_t false_with_debris = 0;  ///< findings far from all debris, work and traces
  std::size_t work_findings = 0;      ///< findings of planned work
  std::size_t trace_findings = 0;     ///< findings of dust, smears and fingerprints
  std::vector<bool> found;            ///< of each target; none where the registration was not trusted
};

/// One simulated inspection of a moved camera and its results.
struct MovedInspection {
  std::uint64_t seed = 0;  ///< determines everything random
  double move_m = 0.0;     ///< true distance between the camera's poses before and after
  double turn_deg = 0.0;   ///< true angle between them
  /// Of a robot that stayed, means over the captures after the work: how far each was in truth from the
  /// baseline's pose, and how often that was approached.
  double off_baseline_deg = 0.0;
  double approaches = 1.0;           ///< see `off_baseline_deg`
  std::string matcher;               ///< of the camera
  double ambient = 0.0;              ///< light, relative to the projector's mean at one metre
  std::vector<MovedTarget> targets;  ///< debris in the first final capture
  /// Without debris and with it, for each number of captures. None where pixels were compared with pixels.
  std::vector<MovedRegistration> registrations;
  std::vector<MovedResult> results;  ///< one for each method, setting and number of captures
};

/// Runs inspections, as many at a time as the processor has cores: dithered captures before, others after it
/// in which nothing changed, and others with debris (random_moved_wing()), taken and compared as `rva serve`
/// does it. An inspection's result depends on its seed alone.
/// @param earlier  those of a study that was interrupted, which is gone on with
/// @param progress called from one thread at a time
/// @param keep     gets the inspections that are done without a gap, in the order of their seeds, whenever
///                 there are more of them; called from one thread at a time
/// @throws UsageError for options out of range; Interrupted
[[nodiscard]] std::vector<MovedInspection> run_moved_study(
    const MovedStudyOptions& options, std::vector<MovedInspection> earlier, const Progress& progress,
    const std::function<void(const std::vector<MovedInspection>&)>& keep);

}  // namespace rva
