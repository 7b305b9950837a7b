// Pictures for the review of findings: before and after the work in one view, aligned pixel by pixel.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "depth/image.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/findings/detection.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// All pictures have the size and the view of the final depth image, so that a point has the same pixel in
/// each. Pictures in colour are grey beyond the colour imager's view, and empty if the capture has no colour.
/// Pictures of depth are colourised on one common scale, and black where depth was not measured.
struct ReviewPictures {
  ColorImage initial_color;
  ColorImage final_color;
  ColorImage initial_depth;
  ColorImage final_depth;
  ColorImage changed;        ///< black where nothing changed; the greater the change, the brighter
  ColorImage not_inspected;  ///< black where a change could have been found, striped elsewhere
  /// For each of findable_sizes_mm, dotted where an object of that size would have been found
  /// (findable_mask()), black elsewhere. Empty where the method states no level of detection.
  std::array<ColorImage, findable_sizes_mm.size()> findable;
};

/// Names of the files of the pictures.
[[nodiscard]] std::vector<std::string> review_picture_files();
/// Writes those that are not empty. @param folder exists @throws Error when one cannot be written
void write_review(const ReviewPictures& pictures, const std::filesystem::path& folder);

/// Draws the pictures of a view from its comparison.
/// @param initial, final the first captures of the two sides that were compared
[[nodiscard]] ReviewPictures draw_review(const Capture& initial, const Capture& final,
                                         const Detection& detection);

/// The last depth image of a capture, colourised, as the background on which regions are drawn.
[[nodiscard]] ColorImage draw_depth(const Capture& capture);
/// The last colour image of a capture in the view of its depth image, grey beyond the colour imager's view.
/// Empty if the capture has no colour.
[[nodiscard]] ColorImage draw_color(const Capture& capture);

/// Maps an image into the view of another camera.
/// @param image            taken by `camera`
/// @param camera_from_view transforms points from the other camera's frame to that of `camera`
/// @param view             the other camera
/// @param view_depth_m     depth of its pixels, metres; the median depth is used where it is 0
/// @return an image of the view's size; black outside of `image`
[[nodiscard]] ColorImage seen_from(const ColorImage& image, const Intrinsics& camera,
                                   const Transform& camera_from_view, const Intrinsics& view,
                                   const Image<float>& view_depth_m);

}  // namespace rva
