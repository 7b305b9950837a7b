#include "evaluate/study.hpp"

#include <algorithm>
#include <initializer_list>

#include "core/error.hpp"
#include "core/random.hpp"
#include "detect/static_method.hpp"
#include "scene/traces.hpp"

namespace rva {
namespace {

// Joins blobs that are separated only by the matcher's window, but not more distant ones, so that a method
// that marks changes everywhere does not count as finding everything.
constexpr double join_px = 9.0;

/// A simulated capture that can be extended to more frames.
class Take {
 public:
  Take(Scene scene, const StereoSensorOptions& sensor, std::uint64_t seed)
      : camera_(std::move(scene), sensor, seed, ColorFrames::none),
        statistics_(camera_.info().depth.width, camera_.info().depth.height),
        first_(statistics_) {}

  void up_to(int frames) {
    while (statistics_.frames() < static_cast<std::size_t>(frames)) {
      const DepthImage depth = camera_.wait_for_frame()->depth;
      statistics_.add(depth);
      if (first_.frames() == 0) first_.add(depth);
    }
  }

  [[nodiscard]] const SimulatedCamera& camera() const { return camera_; }
  [[nodiscard]] const DepthStatistics& statistics() const { return statistics_; }
  [[nodiscard]] const DepthStatistics& first() const { return first_; }

 private:
  SimulatedCamera camera_;
  DepthStatistics statistics_;
  DepthStatistics first_;  // of the first frame alone
};

// The number of a detector is the setting that decides how much a method finds.
StaticDetectionOptions options_of(const Detector& detector) {
  StaticDetectionOptions options;
  options.method = value_of<DetectionMethod>(detector.method).value();
  options.constant.threshold_m = options.gaussian.sigmas = options.calibrated.false_findings =
      detector.setting;
  return options;
}

Comparison compare(const Detector& detector, const Take& before, const Take& after) {
  const StaticDetectionOptions options = options_of(detector);
  const StaticMethod& method = static_method(options.method);
  const auto statistics_of = [&](const Take& take) -> const DepthStatistics& {
    return method.first_frame_only ? take.first() : take.statistics();
  };
  return method
      .compare({.initial = statistics_of(before),
                .final = statistics_of(after),
                .info = after.camera().info(),
                .left_out = {}},
               options)
      .comparison;
}

std::vector<Finding> find(const Detector& detector, const Take& before, const Take& after) {
  const Comparison comparison = compare(detector, before, after);
  return find_findings(comparison, {.join_px = join_px}, after.camera().info().depth);
}

Scene without_roles(Scene scene, std::initializer_list<Role> roles) {
  std::erase_if(scene.objects, [&](const SceneObject& object) {
    return std::ranges::find(roles, object.role) != roles.end();
  });
  return scene;
}

/// One bay, seen before and after the work.
struct Wing {
  Scene before;
  Scene after;
};

Wing wing_of(const StudyOptions& options, const std::optional<Scene>& scene, std::uint64_t seed) {
  if (scene) return {without_roles(*scene, {Role::debris, Role::work}), *scene};
  Wing wing{random_wing(seed, options.bay), {}};
  wing.after = wing.before;
  if (options.bay.work) do_work(random_wing_bay(seed, options.bay), random_work(seed), wing.after);
  if (options.bay.traces) leave_traces(random_traces(seed), wing.after);
  drop_debris(wing.after, seed);
  return wing;
}

// The difference between two captures with identical noise is the effect of debris on depth.
void count_shown_by_twins(const Scene& scene, const StereoSensorOptions& sensor, std::uint64_t seed,
                          std::vector<Target>& targets) {
  constexpr int frames = 5;
  Take without(without_roles(scene, {Role::debris}), sensor, mix(seed, 4));
  Take with(scene, sensor, mix(seed, 4));
  for (Take* take : {&without, &with}) take->up_to(frames);
  count_shown(without.statistics(), with.statistics(), stereo_scale(with.camera().info()), targets);
}

SimulatedInspection inspect(const StudyOptions& options, const std::optional<Scene>& scene,
                            std::uint64_t seed, const std::vector<Detector>& detectors) {
  Wing wing = wing_of(options, scene, seed);
  const StereoSensorOptions sensor = options.sensor(seed);
  Take before(wing.before, sensor, mix(seed, 1));
  Take unchanged(std::move(wing.before), sensor, mix(seed, 2));
  Take changed(std::move(wing.after), sensor, mix(seed, 3));
  SimulatedInspection inspection{seed, visible_targets(changed.camera()), {}};
  count_shown_by_twins(changed.camera().scene(), sensor, seed, inspection.targets);
  const OtherChanges others = other_changes(before.camera(), changed.camera());
  for (const int frames : options.frames) {
    for (Take* take : {&before, &unchanged, &changed}) take->up_to(frames);
    for (const Detector& detector : detectors) {
      const auto judged = [&](const std::vector<Finding>& findings) {
        return judge(findings, inspection.targets, before.statistics().width(), before.statistics().height(),
                     others);
      };
      const std::vector<Finding> when_clean = find(detector, before, unchanged);
      const Judgement judgement = judged(find(detector, before, changed));
      inspection.results.push_back({.frames = frames,
                                    .detector = detector,
                                    .false_when_clean = when_clean.size(),
                                    .false_with_debris = judgement.false_findings,
                                    .found = judgement.found,
                                    .found_when_clean = judged(when_clean).found});
    }
  }
  return inspection;
}

void check(const StudyOptions& options) {
  check_options(options);
  const bool ascending = std::ranges::is_sorted(options.frames, std::less_equal{});
  const bool in_range = !options.frames.empty() && options.frames.front() >= 2 &&
                        options.frames.back() <= static_cast<int>(DepthStatistics::max_frames);
  if (!ascending || !in_range)
    throw OptionError("frames", "requires numbers of at least 2 in ascending order",
                      "give for example 10,20,40");
}

bool is_of(const SimulatedInspection& inspection, const std::vector<int>& frames,
           const std::vector<Detector>& detectors) {
  auto result = inspection.results.begin();
  for (const int count : frames) {
    for (const Detector& detector : detectors) {
      if (result == inspection.results.end() || result->frames != count || result->detector != detector)
        return false;
      ++result;
    }
  }
  return result == inspection.results.end();
}

void check(const std::vector<SimulatedInspection>& done, const StudyOptions& options,
           const std::vector<Detector>& detectors) {
  std::uint64_t seed = options.first_seed;
  for (const SimulatedInspection& inspection : done) {
    if (inspection.seed != seed++ || !is_of(inspection, options.frames, detectors))
      throw OptionError("resume", "the existing evaluation has other seeds, frames or methods",
                        "repeat the options of the earlier run, or choose another output folder");
  }
}

}  // namespace

std::vector<Detector> detectors_to_compare() {
  std::vector<Detector> detectors;
  for (const double threshold_m : {0.005, 0.01, 0.02, 0.05}) detectors.push_back({"constant", threshold_m});
  for (const double sigmas : {1.0, 2.0, 3.0, 4.0}) detectors.push_back({"gaussian", sigmas});
  for (const double allowed : {0.001, 0.05, 0.5, 5.0}) detectors.push_back({"calibrated", allowed});
  return detectors;
}

std::vector<SimulatedInspection> run_study(const StudyOptions& options, const std::optional<Scene>& scene,
                                           std::vector<SimulatedInspection> done, const Progress& progress,
                                           const InspectionsDone& keep) {
  check(options);
  const std::vector<Detector> detectors = detectors_to_compare();
  check(done, options, detectors);
  const auto total = static_cast<std::size_t>(options.inspections);
  for (std::size_t i = done.size(); i < total; ++i) {
    done.push_back(inspect(options, scene, options.first_seed + i, detectors));
    if (keep) keep(done);
    if (progress) progress("inspections", i + 1, total);
  }
  return done;
}

}  // namespace rva
