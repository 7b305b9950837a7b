// The surface in the view of one camera, by which images of other views are warped to it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <opencv2/core.hpp>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/stereo_scale.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Inverse depth without holes. Between views a degree apart, an error of a tenth of the depth moves a pixel
/// by a few hundredths of a pixel.
struct ReferenceSurface {
  Intrinsics camera;                 ///< without lens distortion
  Image<float> inverse_depth_per_m;  ///< above 0
};

/// Converts a disparity image. A pixel without a disparity gets that of the nearest one that has it.
/// @param disparity_px 0 where there is none
/// @return an empty image if no pixel has a disparity
[[nodiscard]] ReferenceSurface reference_surface(const Intrinsics& camera, const Image<float>& disparity_px,
                                                 const StereoScale& stereo);

/// Projects single pixels of the reference into another view.
class ViewOfSurface {
 public:
  /// A view of the same camera as the reference's.
  ViewOfSurface(const ReferenceSurface& surface, const Transform& view_from_reference);
  /// @param camera of the view, without lens distortion
  ViewOfSurface(const ReferenceSurface& surface, const Transform& view_from_reference,
                const Intrinsics& camera);

  /// The position in pixels of the view, which may lie outside its image.
  [[nodiscard]] Eigen::Vector2f seen_at(int u, int v) const {
    const float inverse = surface_.inverse_depth_per_m(u, v);
    const Eigen::Vector3f ray = ray_of_corner_ + static_cast<float>(u) * ray_along_u_ +
                                static_cast<float>(v) * ray_along_v_ + inverse * shift_;
    return {fx_ * ray.x() / ray.z() + cx_, fy_ * ray.y() / ray.z() + cy_};
  }

 private:
  const ReferenceSurface& surface_;
  float fx_;
  float fy_;
  float cx_;
  float cy_;
  Eigen::Vector3f ray_along_u_;
  Eigen::Vector3f ray_along_v_;
  Eigen::Vector3f ray_of_corner_;
  Eigen::Vector3f shift_;
};

/// Weights of four neighbouring samples at `t`, 0 to 1, from the second towards the third, by Catmull and
/// Rom: the only cubic of four taps that reproduces a linear slope exactly. OpenCV's cubic is off by 0.04 px
/// there, and its table has steps of a thirty-second of a pixel.
[[nodiscard]] inline Eigen::Array4f cubic_weights(float t) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {0.5F * (-t3 + 2.0F * t2 - t), 0.5F * (3.0F * t3 - 5.0F * t2 + 2.0F),
          0.5F * (-3.0F * t3 + 4.0F * t2 + t), 0.5F * (t3 - t2)};
}

/// Interpolates like cubic_at(), for points within two pixels of the image's border: samples beyond the
/// border take the value of the nearest pixel.
[[nodiscard]] float cubic_at_border(const Image<float>& image, const Eigen::Vector2f& at);

/// Interpolates an image with the cubic of Catmull and Rom.
/// @param at within [0, width - 1] x [0, height - 1]
[[nodiscard]] inline float cubic_at(const Image<float>& image, const Eigen::Vector2f& at) {
  const int left = static_cast<int>(at.x());
  const int top = static_cast<int>(at.y());
  if (left < 1 || top < 1 || left + 2 >= image.width() || top + 2 >= image.height())
    return cubic_at_border(image, at);
  const Eigen::Array4f down = cubic_weights(at.y() - static_cast<float>(top));
  const float* const pixels = &image(left - 1, top - 1);
  const auto row = [&](int k) { return Eigen::Array4f::Map(pixels + std::ptrdiff_t{k} * image.width()); };
  const Eigen::Array4f columns = down[0] * row(0) + down[1] * row(1) + down[2] * row(2) + down[3] * row(3);
  return (cubic_weights(at.x() - static_cast<float>(left)) * columns).sum();
}

/// Maps every pixel of the reference to another view.
class Warp {
 public:
  /// To a view of the same camera as the reference's.
  Warp(const ReferenceSurface& surface, const Transform& view_from_reference);
  /// @param camera as for ViewOfSurface
  Warp(const ReferenceSurface& surface, const Transform& view_from_reference, const Intrinsics& camera);

  /// Warps an image of the view to the reference, by cubic interpolation; 0 outside the view.
  [[nodiscard]] Image<float> image(const Image<float>& of_view) const;
  /// Set where none of the surrounding pixels of the view is set and all are within the view.
  [[nodiscard]] Mask clear_of(const Mask& of_view) const;
  /// False if the pixel is seen within `within_px` of the border of the view, or not at all.
  [[nodiscard]] bool inside(int u, int v, float within_px) const {
    return u_.at<float>(v, u) >= within_px && v_.at<float>(v, u) >= within_px &&
           u_.at<float>(v, u) <= static_cast<float>(view_width_ - 1) - within_px &&
           v_.at<float>(v, u) <= static_cast<float>(view_height_ - 1) - within_px;
  }

 private:
  int view_width_;
  int view_height_;
  cv::Mat u_;
  cv::Mat v_;
};

}  // namespace rva
