#include "inspect/inspector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <system_error>
#include <thread>
#include <utility>

#include "capture/capture.hpp"
#include "core/date_time.hpp"
#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "inspect/baseline_check.hpp"
#include "inspect/closing.hpp"
#include "inspect/person_name.hpp"
#include "inspect/view_comparison.hpp"
#include "map/waypoints.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

constexpr std::size_t most_views = 60;

std::string title(std::int64_t id) { return fmt::format("inspection {}", id); }

// The joints of a robot that rests: two answers of its servos, far enough apart to show a motion, agree.
PanTilt joints_at_rest(Drive& drive) {
  constexpr int most_waits = 15;
  constexpr std::chrono::milliseconds between{200};
  std::optional<PanTilt> before = drive.state_after_asking().joints;
  for (int wait = 0; wait < most_waits; ++wait) {
    std::this_thread::sleep_for(between);
    const DriveState now = drive.state_after_asking();
    if (!now.joints)
      throw Error("robot", "has not reported its position", "check that it is connected, then try again");
    if (before && !now.driving && std::abs(now.joints->pan_deg - before->pan_deg) < servo_step_deg &&
        std::abs(now.joints->tilt_deg - before->tilt_deg) < servo_step_deg)
      return *now.joints;
    before = now.joints;
  }
  throw Error("robot", "is still moving", "wait until it rests, then try again");
}

std::string base_of(std::int64_t id, bool replaced) {
  return fmt::format("inspection-{}{}", id, replaced ? "-replaced" : "");
}

}  // namespace

Inspector::Inspector(const InspectionRig& rig, Records& records, std::filesystem::path data,
                     const InspectorOptions& options)
    : rig_(rig), records_(records), data_(std::move(data)), options_(options) {
  check_options(options_);
  if (options_.lamp && !rig_.camera.has_lamp())
    throw OptionError("lamp", "the camera has none", "leave it out");
  make_folders(data_);
}

std::int64_t Inspector::begin(const InspectionOrder& order) {
  require_person(order.person);
  const PanTilt view =
      rig_.drive == nullptr ? PanTilt{} : rig_.drive->limits().nearest(joints_at_rest(*rig_.drive));
  // Folders left by an inspection whose record was lost must not be taken over by another inspection.
  return records_.add_inspection(order, iso_8601_now(), rig_.drive == nullptr ? 1 : options_.dither, {view},
                                 InspectionFolder::greatest_id(data_));
}

Inspection Inspector::inspection(std::int64_t id) const {
  std::optional<Inspection> found = records_.find(id);
  if (!found) throw Error(title(id), "does not exist", "see the list of inspections");
  return std::move(*found);
}

InspectionHistory Inspector::history(std::int64_t id) const {
  std::optional<InspectionHistory> found = records_.history(id);
  if (!found) throw Error(title(id), "does not exist", "see the list of inspections");
  return std::move(*found);
}

std::vector<PanTilt> Inspector::waypoints_of(const Inspection& inspection) const {
  if (rig_.drive == nullptr) return inspection.views;
  std::vector<PanTilt> waypoints;
  for (const PanTilt& view : inspection.views)
    std::ranges::copy(dithered(view, inspection.dither, rig_.drive->limits()), std::back_inserter(waypoints));
  return waypoints;
}

// An inspection that was begun with a robot cannot be continued without one, nor the other way round.
void Inspector::require_same_rig(const Inspection& inspection) const {
  if (inspection.views.empty()) throw Error(title(inspection.id), "has no view", "add one");
  const std::filesystem::path first = folder(inspection.id).capture(Side::initial, inspection, 0, 0);
  std::error_code ignored;
  const bool with_robot = rig_.drive != nullptr;
  bool began_with_robot = inspection.dither > 1 || inspection.views.size() > 1;
  if (std::filesystem::exists(first / "capture.json", ignored)) {
    const std::optional<Pose> pose = open_capture(first)->info().pose;
    began_with_robot = pose && pose->base == base_of(inspection.id, false);
  } else if (!began_with_robot) {
    return;  // nothing has been captured yet, so either is possible
  }
  if (began_with_robot == with_robot) return;
  throw Error(
      title(inspection.id),
      began_with_robot ? "was begun with a robot" : "was begun with a camera that does not move",
      began_with_robot ? "restart the program with the same robot" : "restart the program without a robot");
}

// Reports a baseline that can no longer be opened before time is spent on a capture or a comparison.
void Inspector::require_baseline(const Inspection& inspection) const {
  const auto dithers = static_cast<int>(waypoints_of(inspection).size() / inspection.views.size());
  for (int view = 0; view < static_cast<int>(inspection.views.size()); ++view) {
    for (int dither = 0; dither < dithers; ++dither)
      static_cast<void>(open_capture(folder(inspection.id).capture(Side::initial, inspection, view, dither)));
  }
}

void Inspector::set_views(std::int64_t id, const std::vector<PanTilt>& views) {
  tasks_.between_starts([&] { change_views(id, views); });
}

void Inspector::change_views(std::int64_t id, const std::vector<PanTilt>& views) {
  const Inspection before = inspection(id);
  if (before.initial || before.begun.contains(Side::initial))
    throw Error(title(id), "the baseline capture has already begun",
                "begin a new inspection for other views");
  if (views.empty() || views.size() > most_views)
    throw Error(title(id), fmt::format("cannot have {} views", views.size()),
                fmt::format("give 1 to {}", most_views));
  if (rig_.drive != nullptr) check_waypoints(views, rig_.drive->limits());
  constexpr double most_deg = 180.0;
  const auto is_angle = [](double deg) { return std::abs(deg) <= most_deg; };
  if (!std::ranges::all_of(
          views, [&](const PanTilt& view) { return is_angle(view.pan_deg) && is_angle(view.tilt_deg); }))
    throw Error(title(id), "cannot have a view beyond 180 degrees", "give other angles");
  if (rig_.drive == nullptr && views.size() > 1)
    throw Error(title(id), "the camera does not move and has one view", "restart the program with a robot");
  records_.set_views(id, views);
}

void Inspector::set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) {
  tasks_.between_starts([&] {
    require_baseline_view(id, view);
    records_.set_ignored(id, view, ignored);
  });
}

void Inspector::set_plan(std::int64_t id, int view, const Plan* plan) {
  tasks_.between_starts([&] {
    require_baseline_view(id, view);
    records_.set_plan(id, view, plan);
  });
}

// That there is a picture of the baseline to draw on, and no task that would not see what is drawn.
void Inspector::require_baseline_view(std::int64_t id, int view) const {
  const Inspection before = inspection(id);
  if (!before.initial) throw Error(title(id), "has no baseline to draw on", "capture the baseline first");
  if (view < 0 || view >= static_cast<int>(before.views.size()))
    throw Error(title(id), fmt::format("has no view {}", view), "give one of its views, from 0");
  require_unchanging(id, "wait until that has finished");
}

void Inspector::check_readiness() {
  tasks_.start({.kind = TaskKind::readiness}, tasks_.ends_asked_for(), [this]() -> TaskRunner::Work {
    return [this] {
      Readiness readiness =
          rva::check_readiness(rig_.camera, rig_.drive, data_, options_.readiness, tasks_.counted_progress());
      const std::lock_guard lock(mutex_);
      readiness_ = std::move(readiness);
    };
  });
}

void Inspector::capture(std::int64_t id, Side side, const std::string& person, bool replaced) {
  const std::uint64_t ends_asked_for = tasks_.ends_asked_for();
  require_person(person);
  tasks_.start({.kind = TaskKind::capture, .inspection = id, .side = side}, ends_asked_for,
               [&] { return capture_work(id, side, person, replaced); });
}

TaskRunner::Work Inspector::capture_work(std::int64_t id, Side side, const std::string& person,
                                         bool replaced) {
  const Inspection before = inspection(id);
  require_open(before);
  if (side == Side::final && !before.initial)
    throw Error(title(id), "has no baseline to compare with", "capture the baseline before the work");
  if (side == Side::initial && before.initial)
    throw Error(title(id), "already has a baseline", "begin a new inspection for another one");
  if (side == Side::initial && replaced)
    throw Error(title(id), "has no baseline yet after which the robot could be put back",
                "state it with the capture after the work");
  require_same_rig(before);
  if (side == Side::final) require_baseline(before);
  const BegunSide round = round_for(before, side, person, base_of(id, replaced));
  const auto captures = static_cast<std::size_t>(std::max(1, before.dither));
  const SideCapture wanted{waypoints_of(before),
                           captures,
                           folder(id).side(side, round.round),
                           round.base,
                           (static_cast<std::size_t>(options_.frames) + captures - 1) / captures,
                           options_.lamp,
                           baseline_to_return_to(before, side, round.base),
                           options_.pose_return};
  folder(id).require_no_links(wanted.folder);
  records_.begin_side(id, side, round);
  return [this, id, side, round, wanted] {
    const std::string taken_at = take_side(rig_, wanted, tasks_.capture_events());
    records_.set_side(id, side, {taken_at, round.person, round.base, round.round});
    if (side == Side::final)
      compare_now(id);
    else
      check_now(id);
  };
}

// Empty without a robot, and after the robot was put back elsewhere: there is no pose to return to then.
std::filesystem::path Inspector::baseline_to_return_to(const Inspection& inspection, Side side,
                                                       const std::string& base) const {
  const bool may_return =
      side == Side::final && rig_.drive != nullptr && inspection.initial && inspection.initial->base == base;
  return may_return ? folder(inspection.id).side(Side::initial, inspection.initial->round)
                    : std::filesystem::path();
}

// An interrupted baseline on a robot continues after the views that it has: no work has been done yet. After
// the work, earlier views might show the bay before somebody worked in it again, so a final side is always
// taken as a whole, in an unused folder.
BegunSide Inspector::round_for(const Inspection& inspection, Side side, const std::string& person,
                               const std::string& base) const {
  const auto begun = inspection.begun.find(side);
  const bool goes_on = side == Side::initial && rig_.drive != nullptr;
  if (goes_on && begun != inspection.begun.end()) return {begun->second.round, person, base};
  const std::optional<TakenSide>& taken = side == Side::initial ? inspection.initial : inspection.final;
  int round =
      std::max(taken ? taken->round : 0, begun == inspection.begun.end() ? 0 : begun->second.round) + 1;
  std::error_code ignored;
  while (std::filesystem::exists(
      std::filesystem::symlink_status(folder(inspection.id).side(side, round), ignored)))
    ++round;
  return {round, person, base};
}

std::optional<bool> Inspector::replaced_before_final(const Inspection& inspection) const {
  const auto begun = inspection.begun.find(Side::final);
  if (rig_.drive == nullptr || begun == inspection.begun.end()) return std::nullopt;
  return begun->second.base == base_of(inspection.id, true);
}

void Inspector::compare(std::int64_t id) {
  tasks_.start({.kind = TaskKind::comparison, .inspection = id}, tasks_.ends_asked_for(),
               [this, id]() -> TaskRunner::Work {
                 const Inspection before = inspection(id);
                 require_open(before);
                 if (!before.initial || !before.final)
                   throw Error(title(id), "was not captured both before and after the work",
                               "take both captures");
                 require_same_rig(before);
                 require_baseline(before);
                 return [this, id] { compare_now(id); };
               });
}

void Inspector::compare_now(std::int64_t id) {
  tasks_.update([](TaskState& task) { task.kind = TaskKind::comparison; });
  const Inspection inspection = this->inspection(id);
  const InspectionFolder folder = this->folder(id);
  int number = inspection.comparisons + 1;
  std::error_code ignored;
  while (std::filesystem::exists(
      std::filesystem::symlink_status(folder.path() / InspectionFolder::comparison_name(number), ignored)))
    ++number;
  const std::string name = InspectionFolder::comparison_name(number);
  folder.require_no_links(folder.path() / name);
  records_.begin_comparison(id, {number, "", name, inspection.final->round});
  const Compared compared = compare_sides(folder, inspection, folder.path() / name, rig_.drive != nullptr,
                                          rig_.chain, tasks_.counted_progress());
  tasks_.throw_if_ended();
  records_.set_comparison(id, {number, iso_8601_now(), name, inspection.final->round}, compared.views,
                          compared.findings);
}

void Inspector::check_now(std::int64_t id) {
  tasks_.update([](TaskState& task) { task.kind = TaskKind::check; });
  check_baseline(folder(id), inspection(id), tasks_.counted_progress());
}

// Whether a capture or a comparison of this inspection is in progress.
bool Inspector::is_changing(std::int64_t id) const {
  const TaskState now = task();
  const bool changes = now.kind == TaskKind::capture || now.kind == TaskKind::comparison;
  return now.end == TaskEnd::running && changes && now.inspection == id;
}

std::optional<Readiness> Inspector::readiness() const {
  const std::lock_guard lock(mutex_);
  return readiness_;
}

void Inspector::require_unchanging(std::int64_t id, const std::string& remedy) const {
  if (is_changing(id)) throw Error(title(id), "is being captured or compared", remedy);
}

}  // namespace rva
