#include "views/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "views/rendered_view.hpp"

namespace rva {
namespace {

// Largest error of the position of an edge, in either direction. It is greater beside a hole, where the
// matcher failed at an edge.
constexpr int edge_reach_px = 2;
constexpr int hole_reach_px = 4;
// Border in which the matcher lacks half of its window. Its errors there depend on the position in the image,
// so they do not cancel if the camera moves.
constexpr int border_px = 2 * margin_px;
// Disparities within reach that differ by less are one surface.
constexpr float one_surface_px = 1.2F;
// A point farther than this behind a surface was hidden.
constexpr float behind_px = 1.0F;
// A point farther than this in front of a surface is on another surface.
constexpr float in_front_px = 1.0F;
constexpr float nearest_m = 0.05F;

cv::Mat square(int reach_px) { return cv::Mat::ones(2 * reach_px + 1, 2 * reach_px + 1, CV_8U); }

/// A disparity image with the range of disparities around each pixel, for comparison with a point.
class Surroundings {
 public:
  explicit Surroundings(const Image<float>& disparity_px) : disparity_px_(disparity_px) {
    const cv::Mat disparity = as_mat(disparity_px_);
    const cv::Mat holes = disparity <= 0.0;
    cv::Mat without_holes = disparity.clone();
    without_holes.setTo(std::numeric_limits<float>::max(), holes);
    cv::Mat beside_holes;
    cv::dilate(holes, beside_holes, square(edge_reach_px));
    cv::dilate(disparity, highest_, square(edge_reach_px));
    cv::erode(without_holes, lowest_, square(edge_reach_px));
    cv::Mat farther;
    cv::dilate(disparity, farther, square(hole_reach_px));
    farther.copyTo(highest_, beside_holes);
    cv::erode(without_holes, farther, square(hole_reach_px));
    farther.copyTo(lowest_, beside_holes);
  }

  // Disparity minus that of the surface at a pixel: interpolated on a surface; at an edge, the distance from
  // the range of disparities within reach. Empty where nothing was measured, and in the border.
  // Equation 43 of docs/math.md.
  [[nodiscard]] std::optional<float> excess_px(float disparity_px, float u, float v) const {
    constexpr auto border = static_cast<float>(border_px);
    const auto right = static_cast<float>(disparity_px_.width() - 1 - border_px);
    const auto bottom = static_cast<float>(disparity_px_.height() - 1 - border_px);
    if (!(u >= border && v >= border && u < right && v < bottom)) return std::nullopt;
    const auto column = static_cast<int>(u);
    const auto row = static_cast<int>(v);
    const float here = between(column, row, u - static_cast<float>(column), v - static_cast<float>(row));
    if (here <= 0.0F) return std::nullopt;
    const float high = highest_.at<float>(row, column);
    const float low = lowest_.at<float>(row, column);
    if (high - low < one_surface_px) return disparity_px - here;
    return disparity_px - std::clamp(disparity_px, low, high);
  }

 private:
  [[nodiscard]] float between(int column, int row, float du, float dv) const {
    const float a = disparity_px_(column, row);
    const float b = disparity_px_(column + 1, row);
    const float c = disparity_px_(column, row + 1);
    const float d = disparity_px_(column + 1, row + 1);
    if (std::min({a, b, c, d}) <= 0.0F) return 0.0F;
    return (1.0F - dv) * ((1.0F - du) * a + du * b) + dv * ((1.0F - du) * c + du * d);
  }

  const Image<float>& disparity_px_;
  cv::Mat highest_;
  cv::Mat lowest_;
};

float lesser(float a, float b) {
  if ((a > 0.0F) != (b > 0.0F)) return 0.0F;
  return std::abs(a) < std::abs(b) ? a : b;
}

// The change of disparity in the final camera, `to`, that has the same depth as `change_px` has in the
// initial camera, `from`. Without this, heights would be off by the square of the ratio of both distances.
// Section 7 of docs/math.md.
float carried_over(float change_px, float from_px, const DepthView& from, float to_px, const DepthView& to) {
  const float farther_m =
      static_cast<float>(from.stereo.focal_baseline_m_px) * (1.0F / (from_px - change_px) - 1.0F / from_px);
  constexpr float least = 1e-3F;  // behind the final camera, there is no disparity
  const float by_to_px =
      std::max(1.0F / to_px + farther_m / static_cast<float>(to.stereo.focal_baseline_m_px), least);
  return to_px - 1.0F / by_to_px;
}

// Subtracts the offset, as if the initial camera had been as warm as the final one.
DepthView without_offset(DepthView view, float offset_px) {
  for (float& disparity_px : view.disparity_px.pixels()) {
    if (disparity_px > 0.0F) disparity_px = std::max(disparity_px - offset_px, 0.0F);
  }
  return view;
}

// Compares the final view with the initial one, pixel by pixel. Empty where the views do not show whether
// there is a change.
class FreeSpace {
 public:
  FreeSpace(const DepthView& initial, const DepthView& final, const Transform& initial_from_final)
      : initial_(initial),
        final_(final),
        rotation_(initial_from_final.linear().cast<float>()),
        translation_(initial_from_final.translation().cast<float>()),
        expected_px_(render(initial, final.camera, final.stereo, initial_from_final.inverse())),
        initial_surroundings_(initial.disparity_px),
        expected_surroundings_(expected_px_),
        final_surroundings_(final.disparity_px) {}

  // Equation 45 of docs/math.md.
  [[nodiscard]] std::optional<float> change_px(int u, int v) const {
    const std::optional<float> along_initial_ray = before_px(u, v);
    const std::optional<float> along_final_ray = after_px(u, v);
    if (along_initial_ray && along_final_ray) return lesser(*along_initial_ray, *along_final_ray);
    // Without a measurement along the initial ray, a point in front of an initial surface is not judged:
    // whether that space was free is unknown.
    if (!along_initial_ray) return along_final_ray < in_front_px ? along_final_ray : std::nullopt;
    return *along_initial_ray > -behind_px ? along_initial_ray : std::nullopt;
  }

 private:
  // Compares the final point with the surface along the ray of the initial camera through it, in disparity of
  // the final camera. Positive in front.
  // Equation 42 of docs/math.md.
  [[nodiscard]] std::optional<float> before_px(int u, int v) const {
    const float z = static_cast<float>(final_.stereo.focal_baseline_m_px) / final_.disparity_px(u, v);
    const Eigen::Vector3f ray(static_cast<float>((u - final_.camera.cx) / final_.camera.fx),
                              static_cast<float>((v - final_.camera.cy) / final_.camera.fy), 1.0F);
    const Eigen::Vector3f point = rotation_ * (z * ray) + translation_;
    if (point.z() < nearest_m) return std::nullopt;
    const float by_z = 1.0F / point.z();
    const float disparity_px = static_cast<float>(initial_.stereo.focal_baseline_m_px) * by_z;
    const Intrinsics& camera = initial_.camera;
    const std::optional<float> change_px = initial_surroundings_.excess_px(
        disparity_px, static_cast<float>(camera.fx) * point.x() * by_z + static_cast<float>(camera.cx),
        static_cast<float>(camera.fy) * point.y() * by_z + static_cast<float>(camera.cy));
    if (!change_px) return change_px;
    return carried_over(*change_px, disparity_px, initial_, final_.disparity_px(u, v), final_);
  }

  // The same along the ray of the final camera, where the initial view has a surface. A removed surface must
  // lie in front of all disparities that the final camera measured within reach.
  // Equation 44 of docs/math.md.
  [[nodiscard]] std::optional<float> after_px(int u, int v) const {
    const auto column = static_cast<float>(u);
    const auto row = static_cast<float>(v);
    const std::optional<float> change =
        expected_surroundings_.excess_px(final_.disparity_px(u, v), column, row);
    if (!change || *change >= 0.0F) return change;
    const std::optional<float> gone = final_surroundings_.excess_px(expected_px_(u, v), column, row);
    return gone ? lesser(*change, -*gone) : *change;
  }

  const DepthView& initial_;
  const DepthView& final_;
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f translation_;
  Image<float> expected_px_;
  Surroundings initial_surroundings_;
  Surroundings expected_surroundings_;
  Surroundings final_surroundings_;
};

void judge(const FreeSpace& space, const DepthView& final, int u, int v, DisparityChange& change) {
  constexpr float least_px = 1e-3F;  // lower limit of a disparity and a deviation, as judged pixels have both
  const float after_px = final.disparity_px(u, v);
  if (after_px <= 0.0F) return;
  change.after_px(u, v) = after_px;
  const std::optional<float> change_px = space.change_px(u, v);
  if (!change_px) return;
  change.before_px(u, v) = std::max(after_px - *change_px, least_px);
  if (!inside_margin(u, v, final.camera.width, final.camera.height, border_px)) return;
  change.judged(u, v) = mask_set;
  change.deviation_px(u, v) = std::max(final.deviation_px(u, v), least_px);
}

}  // namespace

DisparityChange free_space_change(const DepthView& initial, const DepthView& final,
                                  const Transform& initial_from_final, double offset_px) {
  DisparityChange change(final.camera.width, final.camera.height);
  const DepthView before = without_offset(initial, static_cast<float>(offset_px));
  const FreeSpace space(before, final, initial_from_final);
  parallel_bands(final.camera.height, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < final.camera.width; ++u) judge(space, final, u, v, change);
    }
  });
  return change;
}

}  // namespace rva
