#include "detect/spatial/still_evidence.hpp"

#include <array>
#include <utility>

#include "infrared/dot_free_image.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/infrared_check.hpp"
#include "infrared/paired_change.hpp"

namespace rva {
namespace {

InfraredView view_of(const Capture& capture, Light light, float level) {
  const Image<float> grey = capture.infrared_mean(Imager::left, light).value();
  return {grey, Transform::Identity(), light, scale_to_level(level, grey, light)};
}

// True if both images lack dots or have the same other problem: that does not matter, as pixels are compared
// in whatever light both had.
bool are_both_without_dots(const InfraredView& before, const InfraredView& after, Light light) {
  return light == Light::projector && problem_of(before, light) == problem_of(after, light);
}

bool has_pair(const Capture& capture) { return capture.has_infrared(Imager::right, Light::projector); }

std::array<StereoView, 1> pair_of(const Capture& capture, float level, const InfraredView& left) {
  const Image<float> right = capture.infrared_mean(Imager::right, Light::projector).value();
  return {StereoView{left.log_image, log_grey(right, scale_to_level(level, right, Light::projector)),
                     Transform::Identity()}};
}

}  // namespace

std::optional<JudgedChange> still_change_between(const Capture& initial, const Capture& final,
                                                 const DepthView& final_view, Light light,
                                                 std::vector<std::string>& warnings) {
  const float level = exposed_level(final.infrared_mean(Imager::left, light).value(), light);
  const InfraredView before = view_of(initial, light, level);
  const InfraredView after = view_of(final, light, level);
  if (std::string warning = warning_of({&before, 1}, {&after, 1}, light);
      !warning.empty() && !are_both_without_dots(before, after, light)) {
    warnings.push_back(std::move(warning));
    return std::nullopt;
  }
  const ReferenceSurface surface =
      reference_surface(final_view.camera, final_view.disparity_px, final_view.stereo);
  PairedChange pair = still_change(surface, before, after);
  AppearanceChange change{std::move(pair.contrast), std::move(pair.deviations), std::move(pair.judged)};
  drop_faint(change);
  SurfaceChange moved;
  if (light == Light::projector && has_pair(initial) && has_pair(final)) {
    std::array<StereoView, 1> pair_before = pair_of(initial, level, before);
    std::array<StereoView, 1> pair_after = pair_of(final, level, after);
    moved = surface_change(surface, final_view.stereo, pair_before, pair_after);
  }
  return with_tail(std::move(change), tail_of_still_pair, std::move(moved));
}

}  // namespace rva
