// Infrared images of a dithered side without the projector's dots, which show the surface itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "capture/capture.hpp"
#include "depth/image.hpp"
#include "geometry/transform.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// The left infrared image of a capture in one light, or an image of its colour imager, with its pose.
struct InfraredView {
  InfraredView() = default;
  /// @param grey  mean over the frames of the capture, 8-bit grey levels
  /// @param pose  view_from_reference, as far as it is known
  /// @param light under the lamp there are no dots; saturated and unlit pixels are masked instead
  /// @param scale factor applied to all grey levels to equalise exposure, on which the logarithm of
  ///              log_grey() depends in the dark
  InfraredView(const Image<float>& grey, const Transform& pose, Light light = Light::projector,
               float scale = 1.0F);

  Image<float> log_image;  ///< as returned by log_grey()
  Mask saturated;          ///< set where brightness is clipped
  Mask dots;               ///< as returned by dot_mask(): pixels that do not show the surface itself
  Transform view_from_reference = Transform::Identity();  ///< of the imager
  /// Intrinsics of the imager if it is not the left one; without lens distortion.
  std::optional<Intrinsics> camera{};

  /// Maps the reference to this view.
  [[nodiscard]] Warp warp_from(const ReferenceSurface& surface) const {
    return {surface, view_from_reference, camera.value_or(surface.camera)};
  }
};

/// The mean of several views without their dots, in the reference view.
struct DotFreeImage {
  Image<float> log_image;       ///< mean of the samples not covered by dots; 0 where there are none
  Image<float> variance;        ///< of that mean, from the differences of the views nearby; 0 if unknown
  Image<std::uint8_t> samples;  ///< number of views that see the pixel without a dot

  /// Whether any view shows pixel i without a dot.
  [[nodiscard]] bool known(std::size_t i) const { return samples[i] > 0; }
};

/// Fuses views that were taken a few servo steps apart. Their dots fall on different points of the surface,
/// so that together they show nearly all of it without dots.
/// @param views at least one
[[nodiscard]] DotFreeImage fuse(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// The image with the value of the nearest sample at pixels without one.
[[nodiscard]] Image<float> without_gaps(const DotFreeImage& image);

/// Set where both masks, of one size, are set.
[[nodiscard]] Mask both_set(Mask a, const Mask& b);

/// Set where every view sees the pixel well inside its image.
[[nodiscard]] Mask seen_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// Set where every view sees the pixel well inside its image and the field of its projector; beyond that,
/// light falls off with the pose of the camera.
[[nodiscard]] Mask lit_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views);

/// Set where no view that sees the pixel has it beyond the light of its projector, or within
/// `beside_field_px` of that (beyond_projector()).
[[nodiscard]] Mask within_projectors(const ReferenceSurface& surface, std::span<const InfraredView> views);

}  // namespace rva
