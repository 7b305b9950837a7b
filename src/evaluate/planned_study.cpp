#include "evaluate/planned_study.hpp"

#include <algorithm>

#include "core/interrupt.hpp"
#include "core/random.hpp"
#include "detect/detect.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/planned_bay.hpp"
#include "evaluate/robot_side.hpp"
#include "plan/plan_match.hpp"

namespace rva {
namespace {

constexpr int side_captures = 4;
constexpr int side_frames = 10;

bool touches(const LoosePiece& piece, const std::vector<std::uint32_t>& pixels, int width, int within_px) {
  const Box& box = piece.box;
  return std::ranges::any_of(pixels, [&](std::uint32_t i) {
    const int u = static_cast<int>(i) % width;
    const int v = static_cast<int>(i) / width;
    return u >= box.x - within_px && u < box.x + box.width + within_px && v >= box.y - within_px &&
           v < box.y + box.height + within_px;
  });
}

// A part of an item that has no places is missing from its number alone.
bool is_the_missing_one(const PlannedBay& bay, const PlannedGroup& group, const AbsentPart& part) {
  return group.name == bay.item && part.place.value_or(bay.place) == bay.place;
}

void count_missing(const PlannedBay& bay, const PlannedGroup& group, PlannedResult& result) {
  for (const AbsentPart& part : group.missing) {
    if (is_the_missing_one(bay, group, part) && !result.missing_reported)
      result.missing_reported = true;
    else
      ++result.others;
  }
}

PlannedResult judge(const PlannedBay& bay, const PlanMatch& match,
                    const std::vector<std::uint32_t>& lost_pixels, int width) {
  PlannedResult result;
  for (const PlannedGroup& group : match.groups) {
    result.grouped += group.found;
    result.not_inspected += static_cast<int>(group.not_inspected.size());
    count_missing(bay, group, result);
  }
  for (const std::vector<LoosePiece>* const pieces : {&match.unplanned, &match.surplus}) {
    for (const LoosePiece& piece : *pieces) {
      result.lost_reported = result.lost_reported || touches(piece, lost_pixels, width, found_within_px);
      result.others += touches(piece, lost_pixels, width, near_target_px) ? 0 : 1;
    }
  }
  return result;
}

PlannedInspection inspect(const StudyOptions& options, std::uint64_t seed) {
  const CaptureRoom room;
  const PlannedBay bay = random_planned_bay(seed);
  const StereoSensorOptions sensor = options.sensor(seed);
  const RobotSideOptions before_options{
      .captures = side_captures, .frames = side_frames, .rest_error_deg = half_a_step_deg};
  RobotSideOptions after_options = before_options;
  after_options.baseline = Baseline{room.path() / "before", static_cast<std::size_t>(side_captures), {}};
  const RobotSide before =
      take_by_robot(bay.before, sensor, before_options, mix(seed, 1), room.path() / "before");
  const RobotSide after =
      take_by_robot(bay.after, sensor, after_options, mix(seed, 2), room.path() / "after");
  const Captures initial = before.open(side_captures);
  const Captures final = after.open(side_captures);
  const Detection detection = detect(initial, final, {}, {}).detection;
  const ComparedCameras cameras{initial.front()->info().depth, final.front()->info().depth};
  const std::vector<Target> lost = visible_targets(camera_at(bay.after, sensor, after.rested.front()));
  const std::vector<std::uint32_t> lost_pixels =
      lost.empty() ? std::vector<std::uint32_t>() : lost.front().pixels;
  PlannedInspection inspection{.seed = seed,
                               .parts = 0,
                               .findings = detection.findings.findings.size(),
                               .with_places = {},
                               .by_count = {}};
  for (const PlannedItem& item : bay.plan.items) inspection.parts += item.count;
  const int width = cameras.final.width;
  inspection.with_places = judge(bay, match_plan(bay.plan, detection, cameras, {}), lost_pixels, width);
  inspection.by_count =
      judge(bay, match_plan(without_places(bay.plan), detection, cameras, {}), lost_pixels, width);
  return inspection;
}

}  // namespace

std::vector<PlannedInspection> run_planned_study(const StudyOptions& options, const Progress& progress) {
  check_options(options);
  std::vector<PlannedInspection> inspections;
  const auto total = static_cast<std::size_t>(options.inspections);
  for (std::size_t i = 0; i < total; ++i) {
    throw_if_interrupted();
    inspections.push_back(inspect(options, options.first_seed + i));
    if (progress) progress("inspections", i + 1, total);
  }
  return inspections;
}

}  // namespace rva
