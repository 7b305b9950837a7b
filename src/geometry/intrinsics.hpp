// The pinhole camera model: projection between points in front of an imager and its pixels.
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/enum_names.hpp"

namespace rva {

/// Lens distortion models, named as in librealsense (doc/projection.md). Coefficients: k1 k2 p1 p2 k3.
enum class Distortion {
  none,
  brown_conrady,          ///< coefficients map undistorted to distorted points
  inverse_brown_conrady,  ///< coefficients map distorted to undistorted points (D400 colour imager)
};

/// The names that capture files use.
template <>
inline constexpr auto enum_names<Distortion> = std::to_array<EnumName<Distortion>>({
    {Distortion::none, "none"},
    {Distortion::brown_conrady, "brown_conrady"},
    {Distortion::inverse_brown_conrady, "inverse_brown_conrady"},
});

/// The intrinsics of one imager.
///
/// Pixel convention: u to the right, v down, the centre of the first pixel is (0, 0), so the image covers
/// [-0.5, width - 0.5) x [-0.5, height - 0.5).
struct Intrinsics {
  int width = 0;                             ///< px
  int height = 0;                            ///< px
  double fx = 0.0;                           ///< focal length along u, px
  double fy = 0.0;                           ///< focal length along v, px
  double cx = 0.0;                           ///< principal point, px
  double cy = 0.0;                           ///< principal point, px
  Distortion distortion = Distortion::none;  ///< model that `coefficients` belong to
  std::array<double, 5> coefficients{};      ///< k1, k2, p1, p2, k3; ignored if the model is `none`

  /// The pixel of a point, lens distortion included; it may lie outside the image.
  /// @param point in the camera frame, metres, z > 0 (points on or behind the imager have no pixel)
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  /// The point that a pixel shows at a depth.
  /// @param depth_m distance along z, metres (not along the ray)
  /// @return the point in the camera frame, metres
  [[nodiscard]] Eigen::Vector3d deproject(const Eigen::Vector2d& pixel, double depth_m) const;

  /// Whether the pixel lies within the image.
  [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const;

  /// Refuses impossible values.
  /// @throws Error naming the first field whose value no camera can have: not finite, not positive where it
  ///         must be, or absurdly large
  void check() const;

  bool operator==(const Intrinsics&) const = default;
};

}  // namespace rva
