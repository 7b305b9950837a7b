#include "camera/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <vector>

#include "capture/memory_capture.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/quantile.hpp"

namespace rva {
namespace {

double median_distance_m(const DepthImage& image, double unit_m) {
  std::vector<std::uint16_t> measured;
  std::ranges::copy_if(image.pixels(), std::back_inserter(measured),
                       [](std::uint16_t depth) { return depth != no_depth; });
  return measured.empty() ? 0.0 : unit_m * quantile(measured, 0.5);
}

}  // namespace

CameraCheck check_camera(Camera& camera, std::size_t frames, const Progress& progress) {
  assert(frames >= 4);
  std::vector<MemoryFrame> seen;
  CameraCheck check;
  while (seen.size() < frames) {
    throw_if_interrupted();
    std::optional<CameraFrame> frame = camera.wait_for_frame();
    if (!frame)
      throw Error("camera", fmt::format("the recording ended after {} of {} frames", seen.size(), frames),
                  "use fewer frames");
    if (frame->metadata.temperature_c) check.temperature_c = frame->metadata.temperature_c;
    seen.push_back({std::move(frame->depth)});
    if (progress) progress("checking", seen.size(), frames);
  }
  const CaptureInfo info = camera.info();
  check.taken_at = iso_8601_now();
  check.frames = frames;
  check.distance_m = median_distance_m(seen[frames / 2].depth, info.depth_unit_m);
  const Noise noise = measure_noise(MemoryCapture(info, std::move(seen)), {}, {});
  check.noise_mm = noise.report.overall.median_std_mm;
  check.measured = noise.report.fill_rate;
  check.drifting = noise.report.welch_rejected;
  return check;
}

}  // namespace rva
