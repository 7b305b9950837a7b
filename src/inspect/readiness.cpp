#include "inspect/readiness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/findings/detection.hpp"
#include "views/disparity_change.hpp"
#include "views/drift.hpp"

namespace rva {
namespace {

/// Statistics of the frames of the check, in two halves.
struct Watched {
  CaptureInfo info;
  DepthStatistics first;
  DepthStatistics second;
  double duration_s = 0.0;
  double measured = 0.0;
  int repeated = 0;  ///< frames whose depth is that of the frame before
};

double measured_share(const DepthStatistics& statistics) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < statistics.size(); ++i) seen += statistics.seen(i) ? 1U : 0U;
  return static_cast<double>(seen) / static_cast<double>(statistics.size());
}

Watched watch(LiveCamera& live, int frames, const Progress& progress) {
  const std::unique_ptr<Camera> camera = live.every_frame();
  std::optional<CameraFrame> frame = camera->wait_for_frame();
  const CaptureInfo info = camera->info();
  const int width = info.depth.width;
  const int height = info.depth.height;
  Watched watched{info, {width, height}, {width, height}};
  DepthImage before;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < frames && frame; ++i) {
    (2 * i < frames ? watched.first : watched.second).add(frame->depth);
    watched.repeated += frame->depth == before ? 1 : 0;
    before = std::move(frame->depth);
    if (progress) progress("looking", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(frames));
    frame = camera->wait_for_frame();
  }
  watched.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  watched.measured = measured_share(watched.first);
  return watched;
}

ReadinessItem camera_item(const Watched& watched, const ReadinessOptions& options) {
  const double rate_hz = options.frames / std::max(1e-3, watched.duration_s);
  const Intrinsics& depth = watched.info.depth;
  const std::string seen = fmt::format("{}, {} x {} pixels, {:.1f} frames per second",
                                       watched.info.camera.value_or(CameraInfo{"Camera", "", {}}).model,
                                       depth.width, depth.height, rate_hz);
  const std::map<std::string, double> values{
      {"width_px", depth.width}, {"height_px", depth.height}, {"rate_hz", rate_hz}};
  // Noise makes every image differ from the one before.
  if (watched.measured > 0.0 && 2 * watched.repeated >= options.frames)
    return {
        "Camera",
        false,
        fmt::format(
            "{}. It is frozen: {} of {} depth images are the same as the one before. Disconnect the camera "
            "and connect it again.",
            seen, watched.repeated, options.frames),
        "camera-frozen",
        {{"repeated_frames", watched.repeated}, {"frames", options.frames}}};
  if (rate_hz >= options.least_rate_hz) return {"Camera", true, seen + ".", "camera-ready", values};
  return {"Camera", false, seen + ": too few. Use a USB 3 port and cable, and close other programs.",
          "camera-slow", values};
}

ReadinessItem depth_item(const Watched& watched, const ReadinessOptions& options) {
  const std::string seen = fmt::format("{:.0f} % of the view is measured", 100.0 * watched.measured);
  const std::map<std::string, double> values{{"measured", watched.measured}};
  if (watched.measured >= options.least_measured) return {"Depth", true, seen + ".", "depth-ready", values};
  return {
      "Depth", false,
      seen + ": too little. Check that the lens is clean, the projector on, and nothing nearer than 0.2 m.",
      "depth-missing", values};
}

ReadinessItem warm_up_item(const Watched& watched, const ReadinessOptions& options) {
  const StereoScale stereo = stereo_scale(watched.info);
  const DisparityChange change = disparity_change(watched.first, watched.second, stereo);
  const Drift drift = fit_drift(change);
  const int u = watched.info.depth.width / 2;
  const int v = watched.info.depth.height / 2;
  const double drift_px = drift.px()(u, v);
  const double deviation_px = std::sqrt(drift.variance_px2()(u, v));
  // Depth changes by its square times the change of disparity, divided by focal length times baseline.
  const double at_one_metre_mm = mm_per_m * std::abs(drift_px) / stereo.focal_baseline_m_px;
  const std::string seen = fmt::format("depth at one metre moved by {:.2f} mm in {:.0f} seconds",
                                       at_one_metre_mm, watched.duration_s);
  const std::map<std::string, double> values{{"drift_mm", at_one_metre_mm},
                                             {"duration_s", watched.duration_s}};
  constexpr double reliable = 3.0;
  if (std::abs(drift_px) <= std::max(options.most_drift_px, reliable * deviation_px))
    return {"Warm-up", true, fmt::format("The camera is stable: {}.", seen), "camera-stable", values};
  return {"Warm-up", false,
          fmt::format("The camera is still warming up, or was touched: {}. Wait a few minutes.", seen),
          "camera-drifting", values};
}

ReadinessItem robot_item(const Drive* drive) {
  if (drive == nullptr)
    return {"Robot", true, "No robot: the camera does not move and has one view.", "robot-none"};
  const DriveState state = drive->state();
  if (!state.problem.empty()) return {"Robot", false, state.problem, "robot-failed"};
  if (!state.joints)
    return {"Robot", false, "Its position is not known yet. Wait a moment.", "robot-unknown"};
  return {"Robot",
          true,
          fmt::format("Connected: pan {:.1f}, tilt {:.1f} degrees.", state.joints->pan_deg,
                      state.joints->tilt_deg),
          "robot-ready",
          {{"pan_deg", state.joints->pan_deg}, {"tilt_deg", state.joints->tilt_deg}}};
}

ReadinessItem disk_item(const std::filesystem::path& folder, const ReadinessOptions& options) {
  std::error_code failure;
  const std::filesystem::space_info space = std::filesystem::space(folder, failure);
  if (failure)
    return {"Disk", false, fmt::format("The free space cannot be determined: {}.", failure.message()),
            "disk-unknown"};
  const double free_gb = static_cast<double>(space.available) / 1e9;
  const std::string seen = fmt::format("{:.1f} GB free", free_gb);
  const std::map<std::string, double> values{{"free_gb", free_gb}, {"least_free_gb", options.least_free_gb}};
  if (free_gb >= options.least_free_gb) return {"Disk", true, seen + ".", "disk-ready", values};
  return {"Disk", false, fmt::format("{}: at least {:.1f} GB are needed.", seen, options.least_free_gb),
          "disk-full", values};
}

}  // namespace

bool Readiness::ready() const { return std::ranges::all_of(items, &ReadinessItem::ready); }

Readiness check_readiness(LiveCamera& camera, const Drive* drive, const std::filesystem::path& folder,
                          const ReadinessOptions& options, const Progress& progress) {
  Readiness readiness;
  try {
    const Watched watched = watch(camera, options.frames, progress);
    readiness.items = {camera_item(watched, options), depth_item(watched, options),
                       warm_up_item(watched, options)};
  } catch (const Error& error) {
    readiness.items = {{"Camera", false, error.what(), "camera-failed"}};
  }
  readiness.items.push_back(robot_item(drive));
  readiness.items.push_back(disk_item(folder, options));
  readiness.checked_at = iso_8601_now();
  return readiness;
}

}  // namespace rva
