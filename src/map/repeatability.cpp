#include "map/repeatability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "map/dot_free_pictures.hpp"
#include "map/waypoints.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

constexpr double known_turn_deg = 6.0 * servo_step_deg;
// More than a robot's errors are, and half of the known turn: less than a joint that stands still, turns the
// other way or is the other joint would be off.
constexpr double known_tolerance_deg = known_turn_deg / 2.0;

struct Direction {
  double pan = 0.0;
  double tilt = 0.0;
};
constexpr std::array<Direction, 4> directions{{{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}}};

std::string text_of(double pan_deg, double tilt_deg) {
  return fmt::format("pan {:.2f}, tilt {:.2f} degrees", pan_deg, tilt_deg);
}

PanTilt away_from(const PanTilt& pose, const Direction& direction, double by_deg) {
  return {pose.pan_deg + direction.pan * by_deg, pose.tilt_deg + direction.tilt * by_deg};
}

ArrivedFrom arrived_from(double direction) {
  return direction > 0.0 ? ArrivedFrom::larger : ArrivedFrom::smaller;
}

/// The returns to one pose.
class Series {
 public:
  Series(const Rig& rig, DotFreePictures& pictures, const PanTilt& pose, const RepeatabilityOptions& options)
      : rig_(rig),
        pictures_(pictures),
        options_(options),
        result_{pose, first_arrival(pose)},
        gauge_(first_picture()) {
    see_noise();
  }

  /// Turns a little away from the pose, and compares what the camera sees with what the servos report.
  void check_turn() {
    constexpr Direction unlike{1.0, -1.0};  // so that exchanged joints are noticed
    const PanTilt target = away_from(result_.pose, unlike, known_turn_deg);
    const PanTilt there = approach(rig_.robot, target, rig_.clock);
    pictures_.settle();
    result_.known = {there.pan_deg - result_.reported.pan_deg, there.tilt_deg - result_.reported.tilt_deg};
    result_.seen = gauge_.turn_to(pictures_.take(options_.frames));
    const auto agree = [](double seen_deg, double known_deg) {
      return std::abs(seen_deg - known_deg) <= known_tolerance_deg;
    };
    const JointTurn& seen = result_.seen;
    if (seen.correlation >= least_correlation && agree(seen.pan_deg, result_.known.pan_deg) &&
        agree(seen.tilt_deg, result_.known.tilt_deg))
      return;
    throw Error(
        "camera",
        fmt::format("sees a turn of {} where the robot reports {}", text_of(seen.pan_deg, seen.tilt_deg),
                    text_of(result_.known.pan_deg, result_.known.tilt_deg)),
        "check that it is fixed to the robot, the servos' IDs, and that the view is lit and structured");
  }

  void come_back(const Direction& from) {
    move_and_wait(rig_.robot, away_from(result_.pose, from, options_.leave_deg), rig_.clock);
    MeasuredReturn back{arrived_from(from.pan), arrived_from(from.tilt), {}, {}};
    back.reported = move_and_wait(rig_.robot, result_.pose, rig_.clock);
    pictures_.settle();
    back.turn = gauge_.turn_to(pictures_.take(options_.frames));
    if (back.turn.correlation < least_correlation)
      throw Error(text_of(result_.pose.pan_deg, result_.pose.tilt_deg),
                  fmt::format("the camera sees another view after return {}", result_.returns.size() + 1),
                  "let nothing move in view, keep the light steady, and check the robot for loose parts");
    result_.returns.push_back(back);
  }

  [[nodiscard]] PoseReturns take_result() { return std::move(result_); }

 private:
  PanTilt first_arrival(const PanTilt& pose) {
    const PanTilt joints = approach(rig_.robot, pose, rig_.clock);
    pictures_.settle();
    return joints;
  }

  JointTurnGauge first_picture() {
    const ReferenceSurface surface = pictures_.surface(options_.frames);
    return {rig_.chain, result_.reported, pictures_.imager(), surface, pictures_.take(options_.frames)};
  }

  void see_noise() {
    constexpr int pictures = 6;
    for (int i = 0; i < pictures; ++i) {
      const JointTurn turn = gauge_.turn_to(pictures_.take(options_.frames));
      if (turn.correlation < least_correlation)
        throw Error(text_of(result_.pose.pan_deg, result_.pose.tilt_deg),
                    fmt::format("the camera sees too little to measure a turn (its {} pictures hardly agree)",
                                pictures_.name()),
                    "switch a steady light on, or choose waypoints with edges and texture in view");
      result_.still.push_back(turn);
    }
  }

  const Rig& rig_;
  DotFreePictures& pictures_;
  const RepeatabilityOptions& options_;
  PoseReturns result_;
  JointTurnGauge gauge_;
};

void check_poses(const std::vector<PanTilt>& poses, double leave_deg, const RobotLimits& limits) {
  check_waypoints(poses, limits);
  for (const PanTilt& pose : poses) {
    for (const Direction& direction : directions) {
      const PanTilt away = away_from(pose, direction, leave_deg);
      if (limits.nearest(away) == away) continue;
      throw UsageError(text_of(pose.pan_deg, pose.tilt_deg),
                       fmt::format("{:g} degrees around it are beyond the robot's limits", leave_deg),
                       "choose another waypoint, or leave it by less with --leave");
    }
  }
}

}  // namespace

Repeatability measure_repeatability(const Rig& rig, const std::vector<PanTilt>& poses,
                                    const RepeatabilityOptions& options, const Progress& progress) {
  assert(!poses.empty());
  check_options(options);
  check_poses(poses, options.leave_deg, rig.robot.limits());
  DotFreePictures pictures(rig.camera);
  const auto returns = static_cast<std::size_t>(options.returns);
  const auto report = [&](std::size_t done) {
    if (progress) progress("returns", done, poses.size() * returns);
  };
  Repeatability result{std::string(pictures.name()), {}};
  for (const PanTilt& pose : poses) {
    const std::size_t before = result.poses.size() * returns;
    Series series(rig, pictures, pose, options);
    report(before);
    series.check_turn();
    for (std::size_t i = 0; i < returns; ++i) {
      series.come_back(directions.at(i % directions.size()));
      report(before + i + 1);
    }
    result.poses.push_back(series.take_result());
  }
  return result;
}

}  // namespace rva
