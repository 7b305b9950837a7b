#include "detect/appearance/appearance_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "detect/spatial/surface_support.hpp"
#include "geometry/rigid_motion.hpp"
#include "geometry/stereo_scale.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/infrared_alignment.hpp"
#include "infrared/infrared_check.hpp"
#include "infrared/paired_change.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {
namespace {

/// Loads the images of a side with their poses.
/// @param level brightness to which images are scaled, since exposure depends on the content of the view
std::vector<InfraredView> views_of(const Captures& side, Light light, float level,
                                   const std::vector<Transform>& first_from_view,
                                   const Transform& first_from_reference) {
  std::vector<InfraredView> views(side.size());
  parallel_bands(static_cast<int>(side.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
      throw_if_interrupted();
      const Image<float> grey = side[k]->infrared_mean(Imager::left, light).value();
      views[k] = InfraredView(grey, first_from_view[k].inverse() * first_from_reference, light,
                              scale_to_level(level, grey, light));
    }
  });
  return views;
}

// True if a view was turned so far that it was registered wrongly: servos are off by a third of a degree
// at most.
bool turned_far(const std::vector<InfraredView>& views, const std::vector<Transform>& stated) {
  constexpr double far_deg = 1.0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const Transform turn = views[k].view_from_reference * stated[k].inverse();
    if (angle_deg_of(turn) > far_deg) return true;
  }
  return false;
}

std::vector<Transform> poses_of(const std::vector<InfraredView>& views) {
  std::vector<Transform> poses;
  for (const InfraredView& view : views) poses.push_back(view.view_from_reference);
  return poses;
}

// Adds half of the evidence of pairs with dots to the evidence between the dots. The noise of the latter is
// known, while pairs depend on a correction for texture that moved.
AppearanceChange both(AppearanceChange change, const PairedChange& pairs) {
  constexpr float share_of_pairs = 0.5F;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (pairs.judged[i] == 0) continue;
    change.judged[i] = mask_set;
    change.deviations[i] += share_of_pairs * pairs.deviations[i];
    if (std::abs(pairs.contrast[i]) > std::abs(change.contrast[i])) change.contrast[i] = pairs.contrast[i];
  }
  return change;
}

// Excludes the edge of the projector's field, where dots come and go.
Mask well_within(const Mask& lit) {
  constexpr int margin_px = 6;
  Mask within(lit.width(), lit.height());
  cv::Mat target = as_mat(within);
  cv::erode(as_mat(lit), target, cv::Mat::ones(2 * margin_px + 1, 2 * margin_px + 1, CV_8U), {-1, -1}, 1,
            cv::BORDER_CONSTANT, 0);
  return within;
}

// Combines brightness and geometry, whose errors are independent: the squares of the evidence are added.
// Equation 67 of docs/math.md.
AppearanceChange with_surface(AppearanceChange change, const SurfaceChange& surface) {
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (surface.judged[i] == 0) continue;
    const float seen = change.judged[i] != 0 ? change.deviations[i] : 0.0F;
    const float moved = surface.deviations[i];
    change.judged[i] = mask_set;
    change.deviations[i] = std::copysign(std::hypot(seen, moved), seen != 0.0F ? seen : moved);
  }
  return change;
}

std::vector<StereoView> pairs_of(const Captures& side, float level, const std::vector<InfraredView>& left) {
  std::vector<StereoView> pairs(side.size());
  parallel_bands(static_cast<int>(side.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
      throw_if_interrupted();
      const Image<float> right = side[k]->infrared_mean(Imager::right, Light::projector).value();
      pairs[k] = {left[k].log_image, log_grey(right, scale_to_level(level, right, Light::projector)),
                  left[k].view_from_reference};
    }
  });
  return pairs;
}

SurfaceChange surface_between(const Captures& initial, const Captures& final, const ReferenceSurface& surface,
                              const StereoScale& stereo, float level, const std::vector<InfraredView>& before,
                              const std::vector<InfraredView>& after) {
  std::vector<StereoView> pairs_before = pairs_of(initial, level, before);
  std::vector<StereoView> pairs_after = pairs_of(final, level, after);
  SurfaceChange change = surface_change(surface, stereo, pairs_before, pairs_after);
  // At the edge of the projector's field, pairs match light that comes and goes with the camera's pose.
  const Mask field = both_set(within_projectors(surface, before), within_projectors(surface, after));
  for (std::size_t i = 0; i < field.size(); ++i) change.judged[i] &= field[i];
  return change;
}

JudgedChange under_projector(const Captures& initial, const Captures& final, const ReferenceSurface& surface,
                             const StereoScale& stereo, float level, const std::vector<InfraredView>& before,
                             const std::vector<InfraredView>& after, const DotFreeImage& image_before,
                             const DotFreeImage& image_after) {
  const Mask lit = both_set(lit_in_all(surface, after), lit_in_all(surface, before));
  AppearanceChange change = appearance_change(image_before, image_after, lit);
  const PairedChange pairs = paired_change(surface, before, after, image_before, well_within(lit));
  const bool has_pairs = cv::countNonZero(as_mat(pairs.judged)) > 0;
  if (has_pairs) change = both(std::move(change), pairs);
  drop_faint(change);
  SurfaceChange moved;
  if (have_pairs(initial, final)) {
    moved = surface_between(initial, final, surface, stereo, level, before, after);
    change = with_surface(std::move(change), moved);
  }
  return with_tail(std::move(change), has_pairs ? tail_with_pairs : tail_between_dots, std::move(moved));
}

JudgedChange under_lamp(const ReferenceSurface& surface, const std::vector<InfraredView>& before,
                        const std::vector<InfraredView>& after, const DotFreeImage& image_before,
                        const DotFreeImage& image_after) {
  const Mask seen = both_set(seen_in_all(surface, after), seen_in_all(surface, before));
  AppearanceChange change = appearance_change(image_before, image_after, seen);
  drop_faint(change);
  return with_tail(std::move(change), tail_under_lamp);
}

}  // namespace

std::optional<JudgedChange> change_between(const Captures& initial, const Captures& final,
                                           const PlacedCaptures& placed, const Transform& initial_from_final,
                                           Light light, std::vector<std::string>& warnings) {
  const ReferenceSurface surface =
      reference_surface(placed.final_view.camera, placed.final_view.disparity_px, placed.final_view.stereo);
  const float level = exposed_level(final.front()->infrared_mean(Imager::left, light).value(), light);
  std::vector<InfraredView> after =
      views_of(final, light, level, placed.first_from_final, Transform::Identity());
  std::vector<InfraredView> before =
      views_of(initial, light, level, placed.first_from_initial, initial_from_final);
  if (std::string warning = warning_of(before, after, light); !warning.empty()) {
    warnings.push_back(std::move(warning));
    return std::nullopt;
  }
  const std::vector<Transform> stated_after = poses_of(after);
  const std::vector<Transform> stated_before = poses_of(before);
  align_side(surface, after);
  const DotFreeImage image_after = fuse(surface, after);
  align_to(image_after, surface, before);
  if (turned_far(after, stated_after) || turned_far(before, stated_before)) {
    warnings.emplace_back(light == Light::projector
                              ? "the infrared images could not be registered: depth alone was compared"
                              : "the images under the lamp could not be registered: they were not compared");
    return std::nullopt;
  }
  const DotFreeImage image_before = fuse(surface, before);
  return light == Light::projector ? under_projector(initial, final, surface, placed.final_view.stereo, level,
                                                     before, after, image_before, image_after)
                                   : under_lamp(surface, before, after, image_before, image_after);
}

}  // namespace rva
