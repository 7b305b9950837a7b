#include "infrared/reference_surface.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "infrared/gaps.hpp"

namespace rva {

ReferenceSurface reference_surface(const Intrinsics& camera, const Image<float>& disparity_px,
                                   const StereoScale& stereo) {
  Image<float> filled_px = disparity_px;
  if (!fill_gaps(as_mat(disparity_px) <= 0.0, filled_px)) return {camera, {}};
  for (float& value : filled_px.pixels()) value /= static_cast<float>(stereo.focal_baseline_m_px);
  return {camera, std::move(filled_px)};
}

ViewOfSurface::ViewOfSurface(const ReferenceSurface& surface, const Transform& view_from_reference)
    : ViewOfSurface(surface, view_from_reference, surface.camera) {}

ViewOfSurface::ViewOfSurface(const ReferenceSurface& surface, const Transform& view_from_reference,
                             const Intrinsics& camera)
    : surface_(surface),
      fx_(static_cast<float>(camera.fx)),
      fy_(static_cast<float>(camera.fy)),
      cx_(static_cast<float>(camera.cx)),
      cy_(static_cast<float>(camera.cy)),
      shift_(view_from_reference.translation().cast<float>()) {
  const Eigen::Matrix3f turn = view_from_reference.linear().cast<float>();
  const Intrinsics& reference = surface.camera;
  ray_along_u_ = turn.col(0) / static_cast<float>(reference.fx);
  ray_along_v_ = turn.col(1) / static_cast<float>(reference.fy);
  ray_of_corner_ = turn.col(2) - static_cast<float>(reference.cx) * ray_along_u_ -
                   static_cast<float>(reference.cy) * ray_along_v_;
}

float cubic_at_border(const Image<float>& image, const Eigen::Vector2f& at) {
  const int last_u = image.width() - 1;
  const int last_v = image.height() - 1;
  const int left = static_cast<int>(at.x());
  const int top = static_cast<int>(at.y());
  const Eigen::Array4f across = cubic_weights(at.x() - static_cast<float>(left));
  const Eigen::Array4f down = cubic_weights(at.y() - static_cast<float>(top));
  float sum = 0.0F;
  for (int k = 0; k < 4; ++k) {
    const float* const pixels = &image(0, std::clamp(top - 1 + k, 0, last_v));
    const Eigen::Array4f row(pixels[std::max(left - 1, 0)], pixels[left], pixels[std::min(left + 1, last_u)],
                             pixels[std::min(left + 2, last_u)]);
    sum += down[k] * (across * row).sum();
  }
  return sum;
}

Warp::Warp(const ReferenceSurface& surface, const Transform& view_from_reference)
    : Warp(surface, view_from_reference, surface.camera) {}

Warp::Warp(const ReferenceSurface& surface, const Transform& view_from_reference, const Intrinsics& camera)
    : view_width_(camera.width),
      view_height_(camera.height),
      u_(surface.inverse_depth_per_m.height(), surface.inverse_depth_per_m.width(), CV_32F),
      v_(u_.rows, u_.cols, CV_32F) {
  const ViewOfSurface view(surface, view_from_reference, camera);
  parallel_bands(u_.rows, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < u_.cols; ++u) {
        const Eigen::Vector2f at = view.seen_at(u, v);
        u_.at<float>(v, u) = at.x();
        v_.at<float>(v, u) = at.y();
      }
    }
  });
}

Image<float> Warp::image(const Image<float>& of_view) const {
  Image<float> result(u_.cols, u_.rows);
  parallel_bands(u_.rows, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < u_.cols; ++u) {
        if (inside(u, v, 0.0F)) result(u, v) = cubic_at(of_view, {u_.at<float>(v, u), v_.at<float>(v, u)});
      }
    }
  });
  return result;
}

Mask Warp::clear_of(const Mask& of_view) const {
  constexpr double nearly_none = 0.05 * mask_set;
  cv::Mat share;
  cv::remap(as_mat(of_view), share, u_, v_, cv::INTER_LINEAR, cv::BORDER_CONSTANT, mask_set);
  Mask result(u_.cols, u_.rows);
  cv::Mat target = as_mat(result);
  cv::Mat(share < nearly_none).copyTo(target);
  return result;
}

}  // namespace rva
