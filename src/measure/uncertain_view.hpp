// What a camera measured of a still scene, with the uncertainty of each pixel.
#pragma once

#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/stereo_scale.hpp"
#include "measure/measure_options.hpp"

namespace rva {

/// Disparity and its standard uncertainty, both images of the camera's size. In disparity, the noise of a
/// stereo camera is even, and a plane is linear in the ray of a pixel.
struct UncertainView {
  Intrinsics camera;             ///< of the depth images
  StereoScale stereo;            ///< between depth and disparity
  Image<float> disparity_px;     ///< mean over the frames; 0 where depth was not measured in half of them
  Image<float> uncertainty_px;   ///< standard uncertainty of `disparity_px`; 0 where that is 0
  double correlation_px = 11.0;  ///< pixels farther apart than this along u or v have independent errors

  /// Whether pixel (u, v) is inside the image and has a disparity.
  [[nodiscard]] bool seen(int u, int v) const {
    return u >= 0 && v >= 0 && u < camera.width && v < camera.height && disparity_px(u, v) > 0.0F;
  }
  /// The ray of a pixel, with z = 1.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const {
    return camera.deproject(pixel, 1.0);
  }
  /// Correlation of the errors of two pixels that are `du`, `dv` pixels apart (equation 76), 0 to 1.
  [[nodiscard]] double correlation(double du, double dv) const;
};

/// The mean of all frames, with the uncertainty of equation 75.
/// @param depth  one frame or more of a scene in which nothing moved, of the camera's size
/// @param stereo its depth unit is that of the frames
[[nodiscard]] UncertainView uncertain_view(const DepthStatistics& depth, const Intrinsics& camera,
                                           const StereoScale& stereo, const MeasureOptions& options);

}  // namespace rva
