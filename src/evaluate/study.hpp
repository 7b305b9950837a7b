// Evaluation of the static methods on many simulated inspections, with and without debris.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "core/progress.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/random_wing.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// A method at one setting.
struct Detector {
  std::string method;    ///< "constant", "gaussian", "calibrated"
  double setting = 0.0;  ///< threshold in metres; sigmas; allowed false findings

  bool operator==(const Detector&) const = default;
};

/// Each method at the settings that a user would consider.
[[nodiscard]] std::vector<Detector> detectors_to_compare();

/// Options of a study of cameras that stood still.
struct StudyOptions {
  int inspections = 20;                 ///< number of simulated inspections, each without and with debris
  std::uint64_t first_seed = 1;         ///< seed of the first inspection; the next ones follow
  std::vector<int> frames{10, 20, 40};  ///< frames of each capture, ascending
  BayFeatures bay;                      ///< features of random wings
  /// Returns the camera of an inspection, given the inspection's seed.
  std::function<StereoSensorOptions(std::uint64_t seed)> sensor{
      [](std::uint64_t) { return StereoSensorOptions{}; }};

  static void describe(auto&& self, auto&& visit) {
    visit(self.inspections,
          OptionField{"inspections", "", 1, 100000, "simulated inspections, each without and with debris"});
    visit(self.first_seed,
          OptionField{"first-seed", "", 0, 1e15, "seed of the first inspection; the next ones follow"});
  }
};

/// The result of one detector for one inspection and number of frames.
struct Result {
  int frames = 0;                      ///< frames of each capture
  Detector detector;                   ///< method and setting
  std::size_t false_when_clean = 0;    ///< findings where nothing changed
  std::size_t false_with_debris = 0;   ///< findings far from all debris, work and traces
  std::vector<bool> found;             ///< for each target of the inspection
  std::vector<bool> found_when_clean;  ///< the same for the findings where nothing changed: hits by chance
};

/// One simulated inspection of a static camera and its results.
struct SimulatedInspection {
  std::uint64_t seed = 0;       ///< determines everything random
  std::vector<Target> targets;  ///< debris in the view
  std::vector<Result> results;  ///< one for each detector and number of frames
};

/// Called after each inspection with all inspections so far.
using InspectionsDone = std::function<void(const std::vector<SimulatedInspection>&)>;

/// Runs the inspections one after the other. Each consists of three captures from one pose with independent
/// noise: an initial one, one without a change, and one with debris.
/// @param scene a scene with debris; if empty, wings and debris are random
/// @param done  inspections of an earlier run with the same options and scene, which are not run again
/// @throws UsageError for options out of range, or if `done` is from a run with other options; Error from the
///         scene; Interrupted
[[nodiscard]] std::vector<SimulatedInspection> run_study(const StudyOptions& options,
                                                         const std::optional<Scene>& scene,
                                                         std::vector<SimulatedInspection> done,
                                                         const Progress& progress,
                                                         const InspectionsDone& keep);

}  // namespace rva
