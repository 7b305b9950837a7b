#include "evaluate/recorded_study.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/units.hpp"
#include "detect/detect.hpp"
#include "geometry/rigid_motion.hpp"

namespace rva {
namespace {

constexpr std::array allowed_settings{0.05, 0.5, 2.0};

std::set<int> numbers_of_captures(const RecordedScene& scene) {
  constexpr int of_the_console = 4;
  const int most = static_cast<int>(std::min(scene.initial.size(), scene.final.size()));
  return {1, std::min(of_the_console, most), most};
}

std::vector<Target> plain(const RecordedScene& scene) {
  std::vector<Target> targets;
  for (const RecordedTarget& target : scene.targets) targets.push_back(target.target);
  return targets;
}

void note_registration(const RecordedScene& scene, const SidesDetection& found, RecordedResult& result) {
  if (!found.registration || !scene.final_from_initial) return;
  const Transform off = *scene.final_from_initial * found.registration->initial_from_final;
  result.error_mm = mm_per_m * off.translation().norm();
  result.error_deg = angle_deg_of(off);
}

RecordedResult compare(const RecordedScene& scene, int captures, double allowed) {
  RecordedResult result{.captures = captures,
                        .allowed = allowed,
                        .method = {},
                        .found = std::vector<bool>(scene.targets.size(), false),
                        .refused = {}};
  DetectOptions options;
  options.static_camera.calibrated.false_findings = allowed;
  try {
    const auto count = static_cast<std::size_t>(captures);
    const SidesDetection found =
        detect(open_first(scene.initial, count), open_first(scene.final, count), options, {});
    const Judgement judgement =
        judge(found.detection.findings.findings, plain(scene), scene.width, scene.height);
    result.method = found.detection.findings.method;
    result.false_findings = judgement.false_findings;
    result.found = judgement.found;
    note_registration(scene, found, result);
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    result.refused = error.what();
  }
  return result;
}

}  // namespace

std::vector<RecordedInspection> run_recorded_study(const std::filesystem::path& folder,
                                                   const Progress& progress) {
  std::vector<RecordedInspection> done;
  std::vector<RecordedScene> scenes = load_recorded_scenes(folder);
  for (RecordedScene& scene : scenes) {
    RecordedInspection inspection{std::move(scene), {}};
    for (const int captures : numbers_of_captures(inspection.scene)) {
      for (const double allowed : allowed_settings) {
        throw_if_interrupted();
        inspection.results.push_back(compare(inspection.scene, captures, allowed));
      }
    }
    done.push_back(std::move(inspection));
    if (progress) progress("scenes", done.size(), scenes.size());
  }
  return done;
}

}  // namespace rva
