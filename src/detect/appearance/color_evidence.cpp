#include "detect/appearance/color_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/core.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "detect/appearance/color_means.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/infrared_alignment.hpp"
#include "infrared/infrared_check.hpp"
#include "infrared/paired_change.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {
namespace {

// Colour images are compared like those under a lamp: they have no dots, and dark and saturated pixels are
// left out. Unchanged colour images are assumed to have as many peaks, since 30 unchanged bays had none that
// could be fitted.
constexpr Light no_dots = Light::lamp;

// Ambient light is not controlled by the program: people and lamps move in it.
constexpr float least_contrast = 0.08F;
constexpr double most_changed = 0.15;
constexpr double changed_contrast = 0.15;

/// A colour image with the pose of the colour imager, as far as it is known.
struct ColorView {
  ColorMeans color;
  Transform color_from_reference;
};

// The colour images of a side; empty if a capture has none or is dark.
std::optional<std::vector<ColorView>> color_views(const Captures& side,
                                                  const std::vector<Transform>& first_from_view,
                                                  const Transform& first_from_reference) {
  constexpr int frames_of_each = 4;  // captures are averaged as well, and reading colour takes long
  std::vector<std::optional<ColorMeans>> colors(side.size());
  parallel_bands(static_cast<int>(side.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
      throw_if_interrupted();
      colors[k] = color_means(*side[k], frames_of_each);
    }
  });
  std::vector<ColorView> views;
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (!colors[k] || !is_well_lit(*colors[k])) return std::nullopt;
    views.push_back({std::move(*colors[k]), side[k]->info().color_from_depth.value() *
                                                first_from_view[k].inverse() * first_from_reference});
  }
  return views;
}

InfraredView view_of(const ColorView& from, const Image<float>& light, float level) {
  InfraredView view(light, from.color_from_reference, no_dots, scale_to_level(level, light, no_dots));
  for (std::size_t i = 0; i < view.dots.size(); ++i) view.dots[i] |= from.color.moving[i];
  view.camera = from.color.camera;
  return view;
}

std::vector<InfraredView> views_of(const std::vector<ColorView>& side, auto&& light_of, float level) {
  std::vector<InfraredView> views;
  for (const ColorView& from : side) views.push_back(view_of(from, light_of(from.color), level));
  return views;
}

const Image<float>& luminance_of(const ColorMeans& color) { return color.luminance; }

// Refines the poses by registering the luminance images.
void align(const ReferenceSurface& surface, std::vector<ColorView>& initial, std::vector<ColorView>& final) {
  const float level = exposed_level(final.front().color.luminance, no_dots);
  std::vector<InfraredView> after = views_of(final, luminance_of, level);
  std::vector<InfraredView> before = views_of(initial, luminance_of, level);
  align_side(surface, after);
  align_to(fuse(surface, after), surface, before);
  for (std::size_t k = 0; k < after.size(); ++k) final[k].color_from_reference = after[k].view_from_reference;
  for (std::size_t k = 0; k < before.size(); ++k)
    initial[k].color_from_reference = before[k].view_from_reference;
}

// Keeps the stronger of two changes at each pixel.
void take_strongest(AppearanceChange from, AppearanceChange& to) {
  drop_faint(from, least_contrast);
  if (to.judged.empty()) {
    to = std::move(from);
    return;
  }
  for (std::size_t i = 0; i < to.judged.size(); ++i) {
    to.judged[i] |= from.judged[i];
    const auto strength = [i](const AppearanceChange& change) {
      return std::pair(std::abs(change.deviations[i]), std::abs(change.contrast[i]));
    };
    if (strength(from) <= strength(to)) continue;
    to.deviations[i] = from.deviations[i];
    to.contrast[i] = from.contrast[i];
  }
}

// True if so much of the view differs that the lighting must have changed; depth is then used alone.
bool light_changed(const AppearanceChange& change) {
  const int judged = cv::countNonZero(as_mat(change.judged));
  const int changed = cv::countNonZero(cv::abs(as_mat(change.contrast)) > changed_contrast);
  return changed > most_changed * judged;
}

std::optional<JudgedChange> judged_color(AppearanceChange change, std::vector<std::string>& warnings) {
  if (cv::countNonZero(as_mat(change.judged)) == 0) return std::nullopt;
  if (light_changed(change)) {
    warnings.emplace_back(
        "the colours of 15 % of the view or more differ, as when the lighting changed: colour images were "
        "not compared");
    return std::nullopt;
  }
  return with_tail(std::move(change), tail_under_lamp);
}

/// Colour images in the view of the depth camera.
struct OnDepth {
  std::array<InfraredView, 3> channels;
  Mask clear;  ///< set where the colour imager sees the pixel, and nothing moved
};

OnDepth on_depth(const Capture& capture, const ColorMeans& color, const ReferenceSurface& surface,
                 const std::array<float, 3>& levels) {
  constexpr float border_px = 6.0F;
  // Saturated pixels are excluded from the brightness level around them. Pixels that the colour imager does
  // not see must be excluded as well, so they are marked as saturated.
  constexpr float saturated = 1e4F;
  const Warp warp(surface, capture.info().color_from_depth.value(), color.camera);
  OnDepth result{{}, warp.clear_of(color.moving)};
  for (int v = 0; v < result.clear.height(); ++v) {
    for (int u = 0; u < result.clear.width(); ++u) {
      if (!warp.inside(u, v, border_px)) result.clear(u, v) = 0;
    }
  }
  for (std::size_t c = 0; c < levels.size(); ++c) {
    Image<float> light = warp.image(color.channels[c]);
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] =
          result.clear[i] == 0 ? saturated : std::max(light[i], 0.0F);  // cubic interpolation may overshoot
    const float scale = scale_to_level(levels[c], color.channels[c], no_dots);
    result.channels[c] = InfraredView(light, Transform::Identity(), no_dots, scale);
  }
  return result;
}

std::array<float, 3> levels_of(const ColorMeans& color) {
  std::array<float, 3> levels{};
  for (std::size_t c = 0; c < levels.size(); ++c) levels[c] = exposed_level(color.channels[c], no_dots);
  return levels;
}

Mask without(const Mask& taken, Mask from) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (taken[i] != 0) from[i] = 0;
  }
  return from;
}

std::optional<JudgedChange> compare_side_by_side(const Captures& initial, const Captures& final,
                                                 const PlacedCaptures& placed,
                                                 const Transform& initial_from_final,
                                                 std::vector<std::string>& warnings) {
  auto after = color_views(final, placed.first_from_final, Transform::Identity());
  if (!after) return std::nullopt;
  auto before = color_views(initial, placed.first_from_initial, initial_from_final);
  if (!before) return std::nullopt;
  const ReferenceSurface surface =
      reference_surface(placed.final_view.camera, placed.final_view.disparity_px, placed.final_view.stereo);
  align(surface, *before, *after);
  AppearanceChange strongest;
  const std::array<float, 3> levels = levels_of(after->front().color);
  for (std::size_t c = 0; c < levels.size(); ++c) {
    const auto channel = [c](const ColorMeans& color) -> const Image<float>& { return color.channels[c]; };
    const std::vector<InfraredView> views_after = views_of(*after, channel, levels[c]);
    const std::vector<InfraredView> views_before = views_of(*before, channel, levels[c]);
    const Mask seen = both_set(seen_in_all(surface, views_after), seen_in_all(surface, views_before));
    take_strongest(appearance_change(fuse(surface, views_before), fuse(surface, views_after), seen),
                   strongest);
  }
  return judged_color(std::move(strongest), warnings);
}

std::optional<JudgedChange> compare_still(const Capture& initial, const Capture& final,
                                          const DepthView& final_view, std::vector<std::string>& warnings) {
  const std::optional<ColorMeans> color_before = color_means(initial);
  const std::optional<ColorMeans> color_after = color_means(final);
  if (!color_before || !color_after || !is_well_lit(*color_before) || !is_well_lit(*color_after))
    return std::nullopt;
  const ReferenceSurface surface =
      reference_surface(final_view.camera, final_view.disparity_px, final_view.stereo);
  const std::array<float, 3> levels = levels_of(*color_after);
  const OnDepth before = on_depth(initial, *color_before, surface, levels);
  const OnDepth after = on_depth(final, *color_after, surface, levels);
  const Mask clear = both_set(before.clear, after.clear);
  AppearanceChange strongest;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    const InfraredView& earlier = before.channels[c];
    const InfraredView& later = after.channels[c];
    PairedChange pair =
        still_change(surface, earlier, later, without(earlier.dots, without(later.dots, clear)));
    take_strongest({std::move(pair.contrast), std::move(pair.deviations), std::move(pair.judged)}, strongest);
  }
  return judged_color(std::move(strongest), warnings);
}

// Turns an unreadable colour image into a warning, since it must not prevent the comparison of depth.
std::optional<JudgedChange> unless_unreadable(std::vector<std::string>& warnings, auto&& compare) {
  try {
    return compare();
  } catch (const Error& error) {
    warnings.push_back(fmt::format("the colour images were not compared: {}", error.what()));
    return std::nullopt;
  }
}

bool all_have_color(const Captures& side) {
  return std::ranges::all_of(side, [](const auto& capture) { return has_comparable_color(*capture); });
}

bool has_light(const Capture& capture) {
  try {
    const std::optional<ColorMeans> color = color_means(capture, 1);
    return color && is_well_lit(*color);
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

bool have_lit_color(const Captures& initial, const Captures& final) {
  return all_have_color(initial) && all_have_color(final) && has_light(*initial.front()) &&
         has_light(*final.front());
}

std::optional<JudgedChange> color_change_between(const Captures& initial, const Captures& final,
                                                 const PlacedCaptures& placed,
                                                 const Transform& initial_from_final,
                                                 std::vector<std::string>& warnings) {
  return unless_unreadable(
      warnings, [&] { return compare_side_by_side(initial, final, placed, initial_from_final, warnings); });
}

std::optional<JudgedChange> still_color_change_between(const Capture& initial, const Capture& final,
                                                       const DepthView& final_view,
                                                       std::vector<std::string>& warnings) {
  return unless_unreadable(warnings, [&] { return compare_still(initial, final, final_view, warnings); });
}

}  // namespace rva
