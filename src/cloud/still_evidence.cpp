#include "cloud/still_evidence.hpp"

#include <array>
#include <utility>

#include "infrared/dot_free_image.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/lamp_check.hpp"
#include "infrared/paired_change.hpp"

namespace rva {
namespace {

InfraredView view_of(const Capture& capture, Light light, float level) {
  const Image<float> grey = capture.infrared_mean(Imager::left, light).value();
  const float scale = light == Light::lamp ? scale_to_level(level, grey) : 1.0F;
  return {grey, Transform::Identity(), light, scale};
}

bool has_pair(const Capture& capture) { return capture.has_infrared(Imager::right, Light::projector); }

std::array<StereoView, 1> pair_of(const Capture& capture, const InfraredView& left) {
  return {StereoView{left.log_image, log_grey(capture.infrared_mean(Imager::right, Light::projector).value()),
                     Transform::Identity()}};
}

}  // namespace

std::optional<JudgedChange> still_change_between(const Capture& initial, const Capture& final,
                                                 const DepthView& final_view, Light light,
                                                 std::vector<std::string>& warnings) {
  const float level =
      light == Light::lamp ? middle_level(final.infrared_mean(Imager::left, light).value()) : 0.0F;
  const InfraredView before = view_of(initial, light, level);
  const InfraredView after = view_of(final, light, level);
  if (light == Light::lamp) {
    if (std::string warning = warning_under_lamp({&before, 1}, {&after, 1}); !warning.empty()) {
      warnings.push_back(std::move(warning));
      return std::nullopt;
    }
  }
  const ReferenceSurface surface =
      reference_surface(final_view.camera, final_view.disparity_px, final_view.disparity_m_px);
  PairedChange pair = still_change(surface, before, after);
  AppearanceChange change{std::move(pair.contrast), std::move(pair.deviations), std::move(pair.judged)};
  drop_faint(change);
  SurfaceChange moved;
  if (light == Light::projector && has_pair(initial) && has_pair(final)) {
    std::array<StereoView, 1> pair_before = pair_of(initial, before);
    std::array<StereoView, 1> pair_after = pair_of(final, after);
    moved = surface_change(surface, final_view.disparity_m_px, pair_before, pair_after);
  }
  return with_tail(std::move(change), tail_with_pairs, std::move(moved));
}

}  // namespace rva
