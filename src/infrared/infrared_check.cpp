#include "infrared/infrared_check.hpp"

#include <fmt/format.h>

#include <algorithm>
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

Mask everywhere(const Image<float>& image) { return {image.width(), image.height(), mask_set}; }

// How much brighter the brightest dots are than the pixels between dots, in log_grey(). It shows whether the
// dots are real, as dot_mask() finds some in noise.
float rise_of_dots(const InfraredView& view) {
  Mask between = view.dots;
  for (std::uint8_t& pixel : between.pixels()) pixel = pixel == 0 ? mask_set : std::uint8_t{0};
  std::vector<float> on_dots = sampled(as_mat(view.log_image), view.dots);
  std::vector<float> between_dots = sampled(as_mat(view.log_image), between);
  if (on_dots.empty() || between_dots.empty()) return 0.0F;
  return quantile(on_dots, 0.95) - quantile(between_dots, 0.5);
}

std::string problem_under_lamp(const InfraredView& view) {
  constexpr float least_grey = 4.0F;
  constexpr double brighter_share = 0.9;
  constexpr double most_saturated = 0.3;
  constexpr double most_dots = 0.1;  // under the projector it is 0.2 and more
  std::vector<float> levels = sampled(as_mat(view.log_image), everywhere(view.log_image));
  const Image<float> darkest = log_grey(Image<float>(1, 1, least_grey));
  if (levels.empty() || quantile(levels, brighter_share) < darkest[0]) return "it is dark: was the lamp on?";
  if (share_of(view.saturated) > most_saturated) return "most of it is saturated: dim the lamp";
  if (share_of(dot_mask(view.log_image)) > most_dots)
    return "it shows the projector's dots: was the projector off?";
  return "";
}

std::string problem_under_projector(const InfraredView& view) {
  constexpr double most_saturated = 0.5;
  constexpr double least_dots = 0.03;
  constexpr float least_rise = 0.2F;  // a fifth brighter
  if (share_of(view.saturated) > most_saturated) return "most of it is saturated: lower the exposure";
  if (share_of(view.dots) < least_dots || rise_of_dots(view) < least_rise)
    return "it shows hardly any of the projector's dots: was the projector on?";
  return "";
}

}  // namespace

std::string problem_of(const InfraredView& view, Light light) {
  return light == Light::lamp ? problem_under_lamp(view) : problem_under_projector(view);
}

std::string warning_of(std::span<const InfraredView> initial, std::span<const InfraredView> final,
                       Light light) {
  for (const auto& [views, side] : {std::pair(initial, "initial"), std::pair(final, "final")}) {
    for (std::size_t k = 0; k < views.size(); ++k) {
      const std::string problem = problem_of(views[k], light);
      if (!problem.empty())
        return fmt::format("the {} of {} capture {} was not compared, nor any other: {}",
                           light == Light::lamp ? "image under the lamp" : "infrared image", side, k + 1,
                           problem);
    }
  }
  return "";
}

float exposed_level(const Image<float>& grey, Light light) {
  if (light == Light::projector) return static_cast<float>(cv::mean(as_mat(grey))[0]);
  std::vector<float> levels = sampled(as_mat(grey), everywhere(grey));
  return levels.empty() ? 0.0F : quantile(levels, 0.5);
}

float scale_to_level(float level, const Image<float>& grey, Light light) {
  constexpr float most = 4.0F;
  const float own_level = exposed_level(grey, light);
  return own_level > 0.0F ? std::clamp(level / own_level, 1.0F / most, most) : 1.0F;
}

}  // namespace rva
