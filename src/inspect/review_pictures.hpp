// Pictures for a person who decides: before and after in one view, pixel upon pixel.
#pragma once

#include "depth/capture.hpp"
#include "depth/image.hpp"
#include "detect/detection.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// All have the size of the final depth image and show what its imager sees, so that a place has the same
/// pixel in each.
struct ReviewPictures {
  ColorImage
      initial_color;  ///< grey beyond the colour imager's view; empty where the captures have no colour
  ColorImage final_color;
  ColorImage initial_depth;  ///< colourised, of one scale; black where not measured
  ColorImage final_depth;
  ColorImage changed;        ///< black where nothing changed; the stronger the change, the brighter
  ColorImage not_inspected;  ///< black where a change could have been found; else striped
};

/// Of a view and its comparison.
/// @param initial, final the captures that were compared
[[nodiscard]] ReviewPictures draw_review(const Capture& initial, const Capture& final,
                                         const Detection& detection);

/// A capture by itself, of the size of its depth image, to draw regions on.
[[nodiscard]] ColorImage draw_depth(const Capture& capture);
/// The same in colour, grey beyond the colour imager's view. Empty where the capture has no colour.
[[nodiscard]] ColorImage draw_color(const Capture& capture);

/// What an image shows at the places that another camera sees.
/// @param image            of `camera`
/// @param camera_from_view where the image's imager stood
/// @param view             the other camera
/// @param view_depth_m     of its pixels, metres; where 0, the place is taken to be as far as the median
/// @return of the view's size; black where the image does not reach
[[nodiscard]] ColorImage seen_from(const ColorImage& image, const Intrinsics& camera,
                                   const Transform& camera_from_view, const Intrinsics& view,
                                   const Image<float>& view_depth_m);

}  // namespace rva
