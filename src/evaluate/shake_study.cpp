#include "evaluate/shake_study.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/interrupt.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "detect/detect.hpp"
#include "detect/findings/loose_parts.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/loose_bay.hpp"
#include "evaluate/robot_side.hpp"

namespace rva {
namespace {

constexpr RobotSideOptions one_capture{.captures = 1, .frames = 10};

// The part where it was and where it is, as one target.
Target target_of(const LooseBay& bay, const StereoSensorOptions& sensor, const PanTilt& joints) {
  std::vector<Target> now = visible_targets(camera_at(bay.after, sensor, joints));
  const std::vector<Target> then = visible_targets(camera_at(bay.before, sensor, joints));
  Target target = now.empty() ? Target{} : std::move(now.front());
  if (!then.empty()) std::ranges::copy(then.front().pixels, std::back_inserter(target.pixels));
  return target;
}

bool is_at(const LoosePart& part, const std::vector<Finding>& findings, const Target& target,
           const Intrinsics& camera) {
  std::vector<Finding> both;
  std::ranges::copy_if(findings, std::back_inserter(both), [&](const Finding& finding) {
    return finding.id == part.added || finding.id == part.removed;
  });
  const Judgement judgement = judge(both, {target}, camera.width, camera.height);
  return judgement.false_findings == 0 && judgement.found.front();
}

// Angle between the stated and the true motion in the image.
double direction_off_deg(const LoosePart& part, const LooseBay& bay) {
  const Eigen::Vector2d truth = bay.is_m.hnormalized() - bay.was_m.hnormalized();
  const double cosine = part.apart_mm.normalized().dot(truth.normalized());
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

void judge_parts(const Detection& detection, const LooseBay& bay, const Target& target,
                 const Intrinsics& camera, ShakeInspection& inspection) {
  for (const LoosePart& part : find_loose_parts(detection, camera, {})) {
    ++inspection.pairs;
    if (inspection.stated || !is_at(part, detection.findings.findings, target, camera)) continue;
    inspection.stated = true;
    inspection.direction_off_deg = direction_off_deg(part, bay);
  }
}

ShakeInspection inspect(const StudyOptions& options, Shaken shaken, std::uint64_t seed) {
  const CaptureRoom room;
  LooseBay bay = random_loose_bay(seed);
  if (shaken == Shaken::nothing) {
    bay.after = bay.before;
    bay.is_m = bay.was_m;
  }
  const StereoSensorOptions sensor = options.sensor(seed);
  const RobotSide before =
      take_by_robot(bay.before, sensor, one_capture, mix(seed, 1), room.path() / "before");
  const RobotSide after = take_by_robot(bay.after, sensor, one_capture, mix(seed, 2), room.path() / "after");
  const Captures initial = before.open(1);
  const Captures final = after.open(1);
  const Detection detection = detect(initial, final, {}, {}).detection;
  const Intrinsics camera = final.front()->info().depth;
  const Target target = target_of(bay, sensor, after.rested.front());
  const Judgement judgement = judge(detection.findings.findings, {target}, camera.width, camera.height);
  const bool moved = shaken == Shaken::loose;
  ShakeInspection inspection{.seed = seed,
                             .kind = target.kind,
                             .distance_m = target.distance_m,
                             .moved_mm = mm_per_m * (bay.is_m - bay.was_m).norm(),
                             .findings = detection.findings.findings.size(),
                             .others = moved ? judgement.false_findings : detection.findings.findings.size(),
                             .found = moved && judgement.found.front()};
  judge_parts(detection, bay, target, camera, inspection);
  inspection.stated = inspection.stated && moved;
  return inspection;
}

}  // namespace

std::vector<ShakeInspection> run_shake_study(const StudyOptions& options, Shaken shaken,
                                             const Progress& progress) {
  check_options(options);
  std::vector<ShakeInspection> inspections;
  const auto total = static_cast<std::size_t>(options.inspections);
  for (std::size_t i = 0; i < total; ++i) {
    throw_if_interrupted();
    inspections.push_back(inspect(options, shaken, options.first_seed + i));
    if (progress) progress("inspections", i + 1, total);
  }
  return inspections;
}

}  // namespace rva
