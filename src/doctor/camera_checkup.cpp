#include "doctor/camera_checkup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "camera/noise.hpp"
#include "capture/memory_capture.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"
#include "core/quantile.hpp"
#include "core/units.hpp"
#include "doctor/version.hpp"

namespace rva {
namespace {

/// The frames that all checks but the first examine.
struct Seen {
  CaptureInfo info;
  std::vector<MemoryFrame> frames;
  std::uint64_t lost = 0;
  double duration_s = 0.0;  // by the camera's clock
};

Seen see(Camera& camera, std::size_t count, const Progress& progress) {
  Seen seen;
  std::uint64_t first_number = 0;
  double first_s = 0.0;
  while (seen.frames.size() < count) {
    throw_if_interrupted();
    std::optional<CameraFrame> frame = camera.wait_for_frame();
    if (!frame)
      throw Error("camera",
                  fmt::format("the recording ended after {} of {} frames", seen.frames.size(), count),
                  "give fewer with --frames");
    if (seen.frames.empty()) {
      first_number = frame->number;
      first_s = frame->time_s;
    }
    seen.lost = frame->number - first_number - seen.frames.size();
    seen.duration_s = frame->time_s - first_s;
    seen.frames.push_back({std::move(frame->depth)});
    if (progress) progress("checking", seen.frames.size(), count);
  }
  seen.info = camera.info();
  return seen;
}

CheckedItem camera_item(const CaptureInfo& info) {
  const CameraInfo camera = info.camera.value_or(CameraInfo{});
  CheckedItem item =
      passed("camera", fmt::format("{}{}, {}x{} pixels", camera.model.empty() ? "a camera" : camera.model,
                                   camera.serial.empty() ? "" : " " + camera.serial, info.depth.width,
                                   info.depth.height));
  item.result = printable(item.result);
  if (info.notes.empty()) return item;
  item.state = CheckState::warning;
  item.result += "; " + printable(info.notes.front());
  item.advice = "check what this note states; rva info of a capture lists all notes";
  return item;
}

CheckedItem camera_firmware_item(const CaptureInfo& info, bool realsense) {
  constexpr const char* name = "camera-firmware";
  const std::string firmware = info.camera.value_or(CameraInfo{}).firmware;
  if (!realsense || firmware.empty()) return not_tried(name, "the camera states no firmware");
  // That of librealsense 2.50, the oldest version that RVA is built with.
  constexpr std::string_view least = "5.13.0.50";
  const auto numbers = version_numbers(firmware);
  if (numbers && *numbers >= version_numbers(least)) return passed(name, printable(firmware));
  return {name,
          CheckState::warning,
          fmt::format("{} is older than {}", printable(firmware), least),
          "update it with rs-fw-update or realsense-viewer, and run this again",
          {}};
}

CheckedItem rate_item(const Seen& seen, const std::optional<double>& expected_hz) {
  constexpr const char* name = "frame-rate";
  if (seen.duration_s <= 0.0) return not_tried(name, "the camera states no times");
  const double rate_hz = static_cast<double>(seen.frames.size() - 1) / seen.duration_s;
  CheckedItem item = passed(name, fmt::format("{:.1f} frames a second, {} lost", rate_hz, seen.lost));
  item.values = {{"rate_hz", rate_hz}, {"lost_frames", static_cast<double>(seen.lost)}};
  constexpr double nearly = 0.9;
  constexpr double half = 0.5;
  const bool slow = expected_hz && rate_hz < nearly * *expected_hz;
  if (!slow && seen.lost == 0) return item;
  item.state = expected_hz && rate_hz < half * *expected_hz ? CheckState::failed : CheckState::warning;
  if (slow) item.result += fmt::format(", set to {:.0f}", *expected_hz);
  item.advice = "use a USB 3 port and cable, leave out hubs, and close other programs";
  return item;
}

CheckedItem fill_item(double measured, double least) {
  CheckedItem item = passed("fill", fmt::format("{:.1f} % of the depth image is measured", 100.0 * measured));
  item.values = {{"measured", measured}, {"least_measured", least}};
  const double comfortable = 0.5 * (1.0 + least);
  if (measured >= comfortable) return item;
  item.state = measured < least ? CheckState::failed : CheckState::warning;
  item.advice =
      "clean the windows, check that the projector is on, and point it at a matt surface 0.3 to 2 m away";
  return item;
}

// The median over pixels; empty where no pixel was measured twice.
std::optional<double> noise_px(const Noise& noise, const Seen& seen, double baseline_m) {
  const DepthImage& depth = seen.frames[seen.frames.size() / 2].depth;
  std::vector<double> deviations;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double depth_m = seen.info.depth_unit_m * depth.pixels()[i];
    const double std_m = m_per_mm * static_cast<double>(noise.std_mm.pixels()[i]);
    if (depth_m > 0.0 && !std::isnan(std_m))
      deviations.push_back(std_m * seen.info.depth.fx * baseline_m / (depth_m * depth_m));
  }
  if (deviations.empty()) return std::nullopt;
  return quantile(deviations, 0.5);
}

CheckedItem noise_item(const Noise& noise, const Seen& seen, double most_px) {
  constexpr const char* name = "noise";
  const auto baseline_m = seen.info.camera.value_or(CameraInfo{}).baseline_m;
  if (!baseline_m) return not_tried(name, "the distance of the camera's imagers is not known");
  const std::optional<double> px = noise_px(noise, seen, *baseline_m);
  if (!px) return not_tried(name, "no pixel was measured twice");
  CheckedItem item = passed(name, fmt::format("{:.3f} px of disparity, {:.2f} mm of depth (medians)", *px,
                                              noise.report.overall.median_std_mm));
  item.values = {
      {"noise_px", *px}, {"noise_mm", noise.report.overall.median_std_mm}, {"most_noise_px", most_px}};
  constexpr double good = 0.5;
  if (*px <= good * most_px) return item;
  item.state = *px > most_px ? CheckState::failed : CheckState::warning;
  item.result += fmt::format("; a sound camera has {:.2f} px or less", good * most_px);
  item.advice =
      "keep the scene still, clean the windows, avoid sunlight, and calibrate the camera (RealSense: on-chip "
      "calibration in realsense-viewer)";
  return item;
}

CheckedItems items_of(Seen& seen, const CameraNeeds& needs) {
  CheckedItems items{camera_item(seen.info), camera_firmware_item(seen.info, needs.realsense),
                     rate_item(seen, needs.rate_hz)};
  try {
    const Noise noise = measure_noise(MemoryCapture(seen.info, seen.frames), {}, {});
    items.push_back(fill_item(noise.report.fill_rate, needs.options.least_measured));
    items.push_back(noise_item(noise, seen, needs.options.most_noise_px));
  } catch (const Error& error) {  // the same image again and again
    items.push_back(not_tried("fill", "the camera's noise could not be measured"));
    items.push_back(failed("noise", error));
  }
  return items;
}

}  // namespace

std::vector<std::string> camera_check_names() {
  return {"camera", "camera-firmware", "frame-rate", "fill", "noise"};
}

CheckedItems examine_camera(const OpensCamera& open, const CameraNeeds& needs, const Progress& progress) {
  try {
    const std::unique_ptr<Camera> camera = open();
    Seen seen = see(*camera, static_cast<std::size_t>(needs.options.frames), progress);
    return items_of(seen, needs);
  } catch (const UsageError&) {  // a URI of another form: no device was tried
    throw;
  } catch (const Error& error) {
    CheckedItems items = none_tried(camera_check_names(), "the camera gives no frames");
    items.front() = failed("camera", error);
    return items;
  }
}

}  // namespace rva
