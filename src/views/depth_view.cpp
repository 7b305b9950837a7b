#include "views/depth_view.hpp"

#include <cassert>

#include "core/error.hpp"

namespace rva {
namespace {

// Of the mean of frames that alternate between two matches nothing is true.
constexpr double jumping_px = 0.6;

}  // namespace

// Equations 1 and 2 of docs/math.md.
DepthView depth_view(const DepthStatistics& depth, const Intrinsics& camera, const StereoScale& stereo) {
  assert(depth.width() == camera.width && depth.height() == camera.height);
  if (camera.distortion != Distortion::none)
    throw Error("depth intrinsics", "the lens bends rays, and views can only be compared without",
                "record rectified depth, as stereo cameras give it");
  DepthView view{camera, stereo, Image<float>(camera.width, camera.height),
                 Image<float>(camera.width, camera.height)};
  const double product_units_px = stereo.focal_baseline_units_px();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!depth.seen(i)) continue;
    const double by_depth = 1.0 / depth.mean(i);
    const double deviation_px = depth.standard_deviation(i) * product_units_px * by_depth * by_depth;
    if (deviation_px > jumping_px) continue;
    view.disparity_px[i] = static_cast<float>(product_units_px * by_depth);
    view.deviation_px[i] = static_cast<float>(deviation_px);
  }
  return view;
}

DepthView depth_view(const Capture& capture) {
  const CaptureInfo& info = capture.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (std::size_t frame = 0; frame < capture.depth_frames(); ++frame) statistics.add(capture.depth(frame));
  return depth_view(statistics, info.depth, stereo_scale(info));
}

}  // namespace rva
