// Pictures in which people select points, and the depth that is measured there.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "geometry/transform.hpp"
#include "measure/surface_point.hpp"

namespace rva {

/// The camera of a picture that is not the depth image itself.
struct PictureCamera {
  Intrinsics camera;                                     ///< of the picture
  Transform picture_from_depth = Transform::Identity();  ///< from the depth imager to that camera
};

/// A picture whose points are measured in a depth image, which another imager or another pose may have taken.
struct MeasuredPicture {
  UncertainView view;                    ///< of the depth image
  std::optional<PictureCamera> picture;  ///< empty where the picture has the pixels of the depth image

  /// The pixel of the depth image whose surface is visible at a pixel of the picture: the nearest to the
  /// camera, where one surface hides another. Whole pixels where the picture is of another camera.
  /// @return empty where the picture shows nothing whose depth was measured within 3 px, or outside of it
  [[nodiscard]] std::optional<Eigen::Vector2d> depth_pixel(const Eigen::Vector2d& pixel) const;

  /// The point that a pixel of the picture shows.
  /// @return missing_depth, too, where depth_pixel() is empty inside of the picture
  [[nodiscard]] PointOrReason point(const Eigen::Vector2d& pixel, const MeasureOptions& options) const;

  /// The pixels of the depth image that a box of the picture shows, its border included.
  /// @param box in pixels of the picture
  [[nodiscard]] Mask region(const Eigen::AlignedBox2d& box) const;
};

}  // namespace rva
