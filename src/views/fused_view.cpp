#include "views/fused_view.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "views/rendered_view.hpp"

namespace rva {
namespace {

constexpr float agreeing_px = 0.6F;

struct Fused {
  float disparity_px = 0.0F;
  float deviation_px = 0.0F;
};

// Mean and deviation of the disparities near the median; 0 if there are fewer than `least` of them.
// Equation 46 of docs/math.md.
Fused fuse_pixel(std::vector<float>& seen_px, std::size_t least) {
  if (seen_px.size() < least) return {};
  const auto middle = seen_px.begin() + static_cast<std::ptrdiff_t>(seen_px.size() / 2);
  std::nth_element(seen_px.begin(), middle, seen_px.end());
  const float median_px = *middle;
  float count = 0.0F;
  float sum = 0.0F;
  float squares = 0.0F;
  for (const float disparity_px : seen_px) {
    const float off_px = disparity_px - median_px;
    if (std::abs(off_px) > agreeing_px) continue;
    count += 1.0F;
    sum += off_px;
    squares += off_px * off_px;
  }
  if (count < static_cast<float>(least)) return {};
  const float mean_px = sum / count;
  return {median_px + mean_px, std::sqrt(std::max(0.0F, squares / count - mean_px * mean_px))};
}

}  // namespace

DepthView fuse(const std::vector<PlacedView>& views) {
  assert(!views.empty());
  const DepthView& first = views.front().view;
  if (views.size() == 1) return first;
  std::vector<Image<float>> rendered;
  for (std::size_t k = 1; k < views.size(); ++k)
    rendered.push_back(render(views[k].view, first.camera, first.stereo, views[k].first_from_view));
  DepthView fused{first.camera, first.stereo, Image<float>(first.camera.width, first.camera.height),
                  Image<float>(first.camera.width, first.camera.height)};
  const std::size_t least = (views.size() + 1) / 2;
  std::vector<float> seen_px;
  for (std::size_t i = 0; i < first.disparity_px.size(); ++i) {
    seen_px.clear();
    if (first.seen(i)) seen_px.push_back(first.disparity_px[i]);
    for (const Image<float>& disparity_px : rendered) {
      if (disparity_px[i] > 0.0F) seen_px.push_back(disparity_px[i]);
    }
    const Fused pixel = fuse_pixel(seen_px, least);
    fused.disparity_px[i] = pixel.disparity_px;
    fused.deviation_px[i] = pixel.deviation_px;
  }
  return fused;
}

}  // namespace rva
