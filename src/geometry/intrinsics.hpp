// The pinhole camera: between pixels and points in front of the imager.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

namespace rva {

/// How a lens bends rays, by the names of librealsense (doc/projection.md). Coefficients k1 k2 p1 p2 k3.
enum class Distortion {
  none,
  brown_conrady,          ///< coefficients distort: ideal to seen
  inverse_brown_conrady,  ///< coefficients undistort: seen to ideal (the D400's colour imager)
};

/// @return the model that files call by this name; empty for an unknown one
[[nodiscard]] std::optional<Distortion> distortion_from_name(std::string_view name);
[[nodiscard]] std::string_view name_of(Distortion model);

/// One imager's projection.
///
/// Pixel convention: u to the right, v down, the centre of the first pixel is (0, 0), so the image covers
/// [-0.5, width - 0.5) x [-0.5, height - 0.5).
struct Intrinsics {
  int width = 0;    ///< px
  int height = 0;   ///< px
  double fx = 0.0;  ///< focal length along u, px
  double fy = 0.0;  ///< focal length along v, px
  double cx = 0.0;  ///< principal point, px
  double cy = 0.0;  ///< principal point, px
  Distortion distortion = Distortion::none;
  std::array<double, 5> coefficients{};

  /// @param point in the camera frame, metres, z > 0 (points on or behind the imager have no pixel)
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  /// @param depth_m distance along z, metres (not along the ray)
  /// @return the point in the camera frame, metres
  [[nodiscard]] Eigen::Vector3d deproject(const Eigen::Vector2d& pixel, double depth_m) const;

  /// True where the pixel lies on the image.
  [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const;

  /// @throws Error naming the field that no camera can have: not positive, not finite, absurdly large
  void check() const;

  bool operator==(const Intrinsics&) const = default;
};

}  // namespace rva
