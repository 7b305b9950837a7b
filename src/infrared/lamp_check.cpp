#include "infrared/lamp_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

double share_of(const Mask& mask) {
  return static_cast<double>(cv::countNonZero(as_mat(mask))) / static_cast<double>(mask.size());
}

}  // namespace

std::string problem_under_lamp(const InfraredView& view) {
  constexpr float least_grey = 4.0F;
  constexpr double brighter_share = 0.9;
  constexpr double most_saturated = 0.3;
  constexpr double most_dots = 0.1;  // under the projector it is 0.2 and more
  std::vector<float> levels =
      sampled(as_mat(view.log_image), Mask(view.log_image.width(), view.log_image.height(), mask_set));
  const Image<float> darkest = log_grey(Image<float>(1, 1, least_grey));
  if (levels.empty() || quantile(levels, brighter_share) < darkest[0]) return "it is dark: was the lamp on?";
  if (share_of(view.dots) > most_saturated) return "most of it is saturated: dim the lamp";
  if (share_of(dot_mask(view.log_image)) > most_dots)
    return "it shows the projector's dots: was the projector off?";
  return "";
}

std::string warning_under_lamp(std::span<const InfraredView> initial, std::span<const InfraredView> final) {
  for (const auto& [views, side] : {std::pair(initial, "initial"), std::pair(final, "final")}) {
    for (std::size_t k = 0; k < views.size(); ++k) {
      const std::string problem = problem_under_lamp(views[k]);
      if (!problem.empty())
        return fmt::format("the image under the lamp of {} capture {} was not compared, nor any other: {}",
                           side, k + 1, problem);
    }
  }
  return "";
}

float middle_level(const Image<float>& grey) {
  std::vector<float> levels = sampled(as_mat(grey), Mask(grey.width(), grey.height(), mask_set));
  return levels.empty() ? 0.0F : quantile(levels, 0.5);
}

float scale_to_level(float level, const Image<float>& grey) {
  constexpr float most = 4.0F;
  const float own_level = middle_level(grey);
  return own_level > 0.0F ? std::clamp(level / own_level, 1.0F / most, most) : 1.0F;
}

}  // namespace rva
