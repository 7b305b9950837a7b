#include "measure/measured_picture.hpp"

namespace rva {
namespace {

/// A pixel of the depth image as a candidate for a pixel of the picture.
struct Candidate {
  Eigen::Vector2d pixel{0, 0};
  double off_px = 0.0;  ///< distance of its projection from the pixel of the picture
  double depth_m = 0.0;
};

// Where one surface hides another, the nearer one is visible.
bool is_better(const Candidate& a, const Candidate& b) {
  constexpr double same_px = 1.0;
  return a.off_px < b.off_px - same_px || (a.off_px < b.off_px + same_px && a.depth_m < b.depth_m);
}

// Where the surface at a pixel of the depth image is in the picture.
std::optional<Eigen::Vector2d> projected(const UncertainView& view, const PictureCamera& picture, int u,
                                         int v) {
  if (!view.seen(u, v)) return std::nullopt;
  const Eigen::Vector3d point =
      picture.picture_from_depth * (view.stereo.depth_m(view.disparity_px(u, v)) * view.ray({u, v}));
  return point.z() > 0.0 ? std::optional(picture.camera.project(point)) : std::nullopt;
}

std::optional<Eigen::Vector2d> nearest(const UncertainView& view, const PictureCamera& picture,
                                       const Eigen::Vector2d& pixel) {
  constexpr double farthest_px = 3.0;
  std::optional<Candidate> best;
  for (int v = 0; v < view.camera.height; ++v) {
    for (int u = 0; u < view.camera.width; ++u) {
      const std::optional<Eigen::Vector2d> at = projected(view, picture, u, v);
      if (!at) continue;
      const Candidate candidate{{u, v}, (*at - pixel).norm(), view.stereo.depth_m(view.disparity_px(u, v))};
      if (candidate.off_px < farthest_px && (!best || is_better(candidate, *best))) best = candidate;
    }
  }
  return best ? std::optional(best->pixel) : std::nullopt;
}

}  // namespace

std::optional<Eigen::Vector2d> MeasuredPicture::depth_pixel(const Eigen::Vector2d& pixel) const {
  const Intrinsics& camera = picture ? picture->camera : view.camera;
  if (!pixel.allFinite() || !camera.contains(pixel)) return std::nullopt;
  return picture ? nearest(view, *picture, pixel) : std::optional(pixel);
}

PointOrReason MeasuredPicture::point(const Eigen::Vector2d& pixel, const MeasureOptions& options) const {
  const std::optional<Eigen::Vector2d> at = depth_pixel(pixel);
  if (at) return surface_point(view, *at, options);
  const bool inside = pixel.allFinite() && (picture ? picture->camera : view.camera).contains(pixel);
  return inside ? Unmeasured::missing_depth : Unmeasured::outside;
}

Mask MeasuredPicture::region(const Eigen::AlignedBox2d& box) const {
  Mask mask(view.camera.width, view.camera.height);
  for (int v = 0; v < view.camera.height; ++v) {
    for (int u = 0; u < view.camera.width; ++u) {
      const std::optional<Eigen::Vector2d> at =
          picture ? projected(view, *picture, u, v) : std::optional(Eigen::Vector2d(u, v));
      if (at && box.contains(*at)) mask(u, v) = mask_set;
    }
  }
  return mask;
}

}  // namespace rva
