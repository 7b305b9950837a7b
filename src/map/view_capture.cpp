#include "map/view_capture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "camera/recording.hpp"
#include "capture/capture.hpp"
#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "map/waypoints.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

bool is_near(std::optional<double> angle_deg, double waypoint_deg) {
  return angle_deg && std::abs(*angle_deg - waypoint_deg) <= arrival_tolerance_deg;
}

std::unique_ptr<Capture> open_view(const fs::path& folder) {
  try {
    return open_capture(folder);
  } catch (const Error& error) {
    throw Error(error.source(), error.problem(),
                "remove " + printable(folder) + " and resume, so that it is taken again");
  }
}

bool is_of_this_camera(const CaptureInfo& then, const CaptureInfo& now) {
  const auto device = [](const CaptureInfo& info) {
    const CameraInfo camera = info.camera.value_or(CameraInfo{});
    return std::pair(camera.serial, camera.baseline_m);
  };
  return then.depth == now.depth && then.depth_unit_m == now.depth_unit_m && then.color == now.color &&
         device(then) == device(now);
}

// @return false when there is no capture yet
// @throws Error when there is one that differs from what would be taken now
bool is_taken(const fs::path& folder, const PanTilt& waypoint, const CaptureInfo& now,
              const std::string& base, const ViewCaptureOptions& options) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(folder, ignored))) return false;
  const std::unique_ptr<Capture> capture = open_view(folder);
  const CaptureInfo& then = capture->info();
  const Pose pose = then.pose.value_or(Pose{});
  if (!is_near(pose.pan_deg, waypoint.pan_deg) || !is_near(pose.tilt_deg, waypoint.tilt_deg))
    throw Error(
        printable(folder),
        fmt::format("was not taken at pan {:.2f}, tilt {:.2f} degrees", waypoint.pan_deg, waypoint.tilt_deg),
        "resume with the same waypoints, or choose another location");
  if (!is_of_this_camera(then, now) || pose.base != base)
    throw Error(printable(folder), "was taken by another camera or at another base",
                "resume with the same camera and base, or choose another location");
  if (capture->depth_frames() != options.frames)
    throw Error(printable(folder),
                fmt::format("has {} frames, not {}", capture->depth_frames(), options.frames),
                "resume with the same number of frames, or remove it, so that it is taken again");
  if (capture->has_infrared(Imager::left, Light::lamp) != options.lamp)
    throw Error(
        printable(folder),
        options.lamp ? "has no images under the lamp" : "has images under the lamp, which others lack",
        "resume with the lamp on or off as before, or remove it, so that it is taken again");
  return true;
}

Pose pose_of(const Rig& rig, const ReachedPose& reached) {
  Pose pose{rig.base, reached.joints.pan_deg, reached.joints.tilt_deg,
            foot_from_camera(rig.chain, reached.joints)};
  pose.off_baseline_deg = reached.off_deg;
  if (reached.off_deg) pose.approaches = reached.approaches;
  return pose;
}

/// Comes back to the poses of a baseline; what its images show of the poses is worked out view by view.
class BaselineReturn {
 public:
  BaselineReturn(const Rig& rig, const ViewCaptureOptions& options)
      : rig_(rig), baseline_(*options.baseline), settling_(options.settling) {}

  [[nodiscard]] ReachedPose reach(const PanTilt& waypoint, std::size_t number) {
    const std::size_t view = number / baseline_.captures_each;
    if (view != view_ || !poses_) open(view);
    return return_to_pose(rig_, waypoint, *poses_, number % baseline_.captures_each, settling_,
                          baseline_.pose_return, baseline_.on_approach);
  }

 private:
  void open(std::size_t view) {
    poses_.reset();
    captures_.clear();
    for (std::size_t k = 0; k < baseline_.captures_each; ++k)
      captures_.push_back(open_capture(baseline_.folder / view_name(view * baseline_.captures_each + k)));
    poses_.emplace(captures_);
    view_ = view;
  }

  const Rig& rig_;
  const Baseline& baseline_;
  std::size_t settling_;
  std::size_t view_ = 0;
  Captures captures_;
  std::optional<BaselinePoses> poses_;
};

void take_view(const Rig& rig, const std::function<ReachedPose()>& reach, const fs::path& folder,
               const ViewCaptureOptions& options) {
  OutputFolder out(folder, capture_files(), Existing::refuse);
  const ReachedPose reached = reach();
  CaptureInfo info = rig.camera.info();
  info.pose = pose_of(rig, reached);
  CaptureWriter writer(out.path(""), info);
  record(rig.camera, options.frames, writer, {});
  if (options.lamp) record_lamp(rig.camera, options.frames, writer, {});
  out.commit();
}

}  // namespace

std::string view_name(std::size_t number) { return fmt::format("{:03}", number); }

void take_views(const Rig& rig, const std::vector<PanTilt>& waypoints, const fs::path& folder,
                const ViewCaptureOptions& options, const Progress& progress) {
  check_waypoints(waypoints, rig.robot.limits());
  const CaptureInfo info = rig.camera.info();
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (!is_taken(folder / view_name(i), waypoints[i], info, rig.base, options)) missing.push_back(i);
  }
  std::size_t done = waypoints.size() - missing.size();
  if (progress) progress("views", done, waypoints.size());
  std::optional<BaselineReturn> baseline;
  if (options.baseline && options.baseline->pose_return.approaches > 1) baseline.emplace(rig, options);
  for (const std::size_t i : missing) {
    const auto reach = [&] {
      return baseline ? baseline->reach(waypoints[i], i)
                      : ReachedPose{approach_and_settle(rig, waypoints[i], options.settling)};
    };
    take_view(rig, reach, folder / view_name(i), options);
    if (progress) progress("views", ++done, waypoints.size());
  }
}

}  // namespace rva
