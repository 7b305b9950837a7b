#include "infrared/reference_surface.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"

namespace rva {

ReferenceSurface reference_surface(const Intrinsics& camera, const Image<float>& disparity_px,
                                   double disparity_m_px) {
  const cv::Mat empty = as_mat(disparity_px) <= 0.0;
  if (static_cast<std::size_t>(cv::countNonZero(empty)) == disparity_px.size()) return {camera, {}};
  cv::Mat distance;
  cv::Mat nearest;  // the number of the nearest pixel that is not set
  cv::distanceTransform(empty, distance, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
  std::vector<float> of_number(disparity_px.size() + 1, 0.0F);
  for (std::size_t i = 0; i < disparity_px.size(); ++i) {
    if (disparity_px[i] > 0.0F)
      of_number[static_cast<std::size_t>(nearest.ptr<int>()[i])] =
          disparity_px[i] / static_cast<float>(disparity_m_px);
  }
  ReferenceSurface surface{camera, Image<float>(disparity_px.width(), disparity_px.height())};
  for (std::size_t i = 0; i < disparity_px.size(); ++i)
    surface.inverse_depth_per_m[i] = of_number[static_cast<std::size_t>(nearest.ptr<int>()[i])];
  return surface;
}

Warp::Warp(const ReferenceSurface& surface, const Transform& view_from_reference)
    : u_(surface.inverse_depth_per_m.height(), surface.inverse_depth_per_m.width(), CV_32F),
      v_(u_.rows, u_.cols, CV_32F) {
  const Intrinsics& camera = surface.camera;
  const Eigen::Matrix3f turn = view_from_reference.linear().cast<float>();
  const Eigen::Vector3f shift = view_from_reference.translation().cast<float>();
  const auto fx = static_cast<float>(camera.fx);
  const auto fy = static_cast<float>(camera.fy);
  const auto cx = static_cast<float>(camera.cx);
  const auto cy = static_cast<float>(camera.cy);
  parallel_bands(u_.rows, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      const Eigen::Vector3f row = turn * Eigen::Vector3f(-cx / fx, (static_cast<float>(v) - cy) / fy, 1.0F);
      const Eigen::Vector3f step = turn.col(0) / fx;
      float* const to_u = u_.ptr<float>(v);
      float* const to_v = v_.ptr<float>(v);
      const float* const inverse = &surface.inverse_depth_per_m(0, v);
      for (int u = 0; u < u_.cols; ++u) {
        const auto at = static_cast<float>(u);
        const float x = row.x() + at * step.x() + inverse[u] * shift.x();
        const float y = row.y() + at * step.y() + inverse[u] * shift.y();
        const float z = row.z() + at * step.z() + inverse[u] * shift.z();
        to_u[u] = fx * x / z + cx;
        to_v[u] = fy * y / z + cy;
      }
    }
  });
}

Image<float> Warp::image(const Image<float>& of_view) const {
  Image<float> result(u_.cols, u_.rows);
  cv::Mat target = as_mat(result);
  cv::remap(as_mat(of_view), target, u_, v_, cv::INTER_CUBIC, cv::BORDER_CONSTANT, 0.0);
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
