#include "classify/surroundings.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

#include "depth/mat_view.hpp"

namespace rva {

Box surroundings_of(const Box& box, int width, int height) {
  constexpr int times = 2;
  constexpr int least_px = 32;  // fewer pixels show no shape
  const int side = std::max(least_px, times * std::max(box.width, box.height));
  Box part{0, 0, std::min(side, width), std::min(side, height)};
  part.x = std::clamp(box.x + (box.width - part.width) / 2, 0, width - part.width);
  part.y = std::clamp(box.y + (box.height - part.height) / 2, 0, height - part.height);
  return part;
}

ColorImage part_of(const ColorImage& picture, const Box& part) {
  ColorImage copy(part.width, part.height);
  as_mat(picture)(cv::Rect(part.x, part.y, part.width, part.height)).copyTo(as_mat(copy));
  return copy;
}

}  // namespace rva
