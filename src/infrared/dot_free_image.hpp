// Infrared images of a dithered side, without the projector's dots: what the surface itself looks like.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "depth/capture.hpp"
#include "depth/image.hpp"
#include "geometry/transform.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// A capture's left infrared image in one light, or what its colour imager saw, and where it was taken.
struct InfraredView {
  InfraredView() = default;
  /// @param grey  mean of the capture's frames, levels of 8 bits
  /// @param pose  view_from_reference, as far as it is known
  /// @param light under the lamp there are no dots, and what is saturated or not lit is covered instead
  /// @param scale by which all grey levels are multiplied first, so that exposures are alike: in the dark,
  /// the
  ///              logarithm of log_grey() depends on them
  InfraredView(const Image<float>& grey, const Transform& pose, Light light = Light::projector,
               float scale = 1.0F);

  Image<float> log_image;  ///< as of log_grey()
  Mask saturated;          ///< where brightness is cut off
  Mask dots;               ///< as of dot_mask(): what does not show the surface itself
  Transform view_from_reference = Transform::Identity();
  /// The imager that took the image, where it is not the left one; without lens distortion.
  std::optional<Intrinsics> camera{};

  [[nodiscard]] Warp warp_from(const ReferenceSurface& surface) const {
    return {surface, view_from_reference, camera.value_or(surface.camera)};
  }
};

/// All images are in the reference's view.
struct DotFreeImage {
  Image<float> log_image;       ///< mean of what no dot covers; 0 where there is none
  Image<float> variance;        ///< of that mean, by how far the views differ nearby; 0 where unknown
  Image<std::uint8_t> samples;  ///< views that see the pixel without a dot

  [[nodiscard]] bool known(std::size_t i) const { return samples[i] > 0; }
};

/// Views from a few servo steps apart have their dots elsewhere: between them they show nearly every place
/// without one.
/// @param views at least one
[[nodiscard]] DotFreeImage fuse(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// A pixel without a sample gets what the nearest one has.
[[nodiscard]] Image<float> without_gaps(const DotFreeImage& image);

/// Set where both masks of one size are.
[[nodiscard]] Mask both_set(Mask a, const Mask& b);

/// Set where every view sees the pixel well inside its image.
[[nodiscard]] Mask seen_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// Set where every view sees the pixel well inside its image and its projector's field: beyond, light falls
/// off with the camera's pose.
[[nodiscard]] Mask lit_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// Set where no view that sees the pixel has it beyond its projector's light, or within
/// `beside_field_px` of that (beyond_projector()).
[[nodiscard]] Mask within_projectors(const ReferenceSurface& surface, std::span<const InfraredView> views);

}  // namespace rva
