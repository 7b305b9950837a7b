#include "infrared/infrared_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double smoothing_px = 0.8;
constexpr int wide_px = 61;
constexpr float tukey_log = 0.4F;
constexpr int most_rounds = 12;
constexpr double settled_deg = 0.001;
// How far a turn of a quarter of a degree about joints some 0.1 m away shifts the camera.
constexpr double usual_shift_m = 0.0005;
// Neighbours share noise after smoothing and interpolation: so many pixels tell what one would.
constexpr double pixels_that_agree = 10.0;

/// The mean of the set pixels around each; `missing` where hardly any is.
cv::Mat masked_mean(const cv::Mat& values, const cv::Mat& weights, const auto& blur, const cv::Mat& missing) {
  constexpr double hardly_any = 0.05;
  cv::Mat sum;
  cv::Mat share;
  blur(values.mul(weights), sum);
  blur(weights, share);
  cv::Mat mean = sum / (share + 1e-6);
  missing.copyTo(mean, share < hardly_any);
  return mean;
}

const auto narrow = [](const cv::Mat& from, cv::Mat& to) {
  cv::GaussianBlur(from, to, {}, smoothing_px);
};
const auto wide = [](const cv::Mat& from, cv::Mat& to) { cv::blur(from, to, {wide_px, wide_px}); };

cv::Mat as_weights(const cv::Mat& mask) {
  cv::Mat weights;
  mask.convertTo(weights, CV_32F, 1.0 / mask_set);
  return weights;
}

/// What views are laid upon.
class Target {
 public:
  Target(const DotFreeImage& image, const ReferenceSurface& surface) : surface_(surface) {
    filled_ = without_gaps(image);
    weights_ = as_weights(as_mat(image.samples) > 0);
    smooth_ = masked_mean(as_mat(filled_), weights_, narrow, as_mat(filled_));
    constexpr double per_px = 1.0 / 8.0;  // of Sobel's sums
    cv::Sobel(smooth_, along_u_, CV_32F, 1, 0, 3, per_px);
    cv::Sobel(smooth_, along_v_, CV_32F, 0, 1, 3, per_px);
  }

  /// The view's pose after one step; `turn_deg` is how far it turned.
  [[nodiscard]] Transform step(const InfraredView& view, double& turn_deg) const {
    const Warp warp(surface_, view.view_from_reference);
    const Mask clear = warp.clear_of(view.dots);
    const cv::Mat weights = as_weights(as_mat(clear)).mul(weights_);
    const Image<float> image = warp.image(view.log_image);
    const cv::Mat smooth = masked_mean(as_mat(image), as_weights(as_mat(clear)), narrow, smooth_);
    const cv::Mat difference = smooth - smooth_;
    const cv::Mat level = masked_mean(difference, weights, wide, cv::Mat::zeros(difference.size(), CV_32F));
    const Vector6 motion = solve(difference - level, weights);
    turn_deg = motion.head<3>().norm() * 180.0 / std::numbers::pi;
    return moved(view.view_from_reference, -motion);
  }

 private:
  // A small motion of the view: it turns by the first three and shifts by the last three.
  static Transform moved(const Transform& view_from_reference, const Vector6& by) {
    const double angle = by.head<3>().norm();
    Transform motion = Transform::Identity();
    if (angle > 0.0) motion.linear() = Eigen::AngleAxisd(angle, by.head<3>() / angle).toRotationMatrix();
    motion.translation() = by.tail<3>();
    return motion * view_from_reference;
  }

  // How the smooth image at a pixel changes with the motion of the camera.
  [[nodiscard]] Vector6 slope(int u, int v) const {
    const Intrinsics& camera = surface_.camera;
    const double x = (u - camera.cx) / camera.fx;
    const double y = (v - camera.cy) / camera.fy;
    const double inverse = static_cast<double>(surface_.inverse_depth_per_m(u, v));
    const double gu = camera.fx * static_cast<double>(along_u_.at<float>(v, u));
    const double gv = camera.fy * static_cast<double>(along_v_.at<float>(v, u));
    Vector6 slope;
    slope << -x * y * gu - (1.0 + y * y) * gv, (1.0 + x * x) * gu + x * y * gv, x * gv - y * gu, inverse * gu,
        inverse * gv, -inverse * (x * gu + y * gv);
    return slope;
  }

  [[nodiscard]] Vector6 solve(const cv::Mat& residual, const cv::Mat& weights) const {
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    std::vector<float> sizes;
    for (int v = 0; v < residual.rows; ++v) {
      const float* const r = residual.ptr<float>(v);
      const float* const w = weights.ptr<float>(v);
      for (int u = 0; u < residual.cols; ++u) {
        if (w[u] < 0.5F || std::abs(r[u]) >= tukey_log) continue;
        const float share = r[u] / tukey_log;
        const double weight = std::pow(1.0 - static_cast<double>(share * share), 2);
        const Vector6 j = slope(u, v);
        normal.selfadjointView<Eigen::Lower>().rankUpdate(j, weight);
        right += weight * static_cast<double>(r[u]) * j;
        if (u % 7 == 0) sizes.push_back(std::abs(r[u]));
      }
    }
    if (sizes.empty()) return Vector6::Zero();
    const auto deviation = static_cast<double>(robust_deviation(sizes));
    Matrix6 all = normal.selfadjointView<Eigen::Lower>();
    const double prior = pixels_that_agree * deviation * deviation / (usual_shift_m * usual_shift_m);
    all.diagonal().tail<3>().array() += prior;
    all.diagonal().array() += 1e-9;
    return all.ldlt().solve(right);
  }

  const ReferenceSurface& surface_;
  Image<float> filled_;
  cv::Mat weights_;
  cv::Mat smooth_;
  cv::Mat along_u_;
  cv::Mat along_v_;
};

// @return how far the view that turned most did
double step_all(const Target& target, std::vector<InfraredView>& views) {
  std::vector<double> turns_deg(views.size(), 0.0);
  parallel_bands(static_cast<int>(views.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      views[k].view_from_reference = target.step(views[k], turns_deg[k]);
  });
  return *std::ranges::max_element(turns_deg);
}

}  // namespace

void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views) {
  for (int round = 0; round < most_rounds; ++round) {
    const DotFreeImage image = fuse(surface, views);
    const Target target(image, surface);
    const double turned_deg = step_all(target, views);
    const Transform reference_from_first = views.front().view_from_reference.inverse();
    for (InfraredView& view : views) view.view_from_reference = view.view_from_reference * reference_from_first;
    views.front().view_from_reference = Transform::Identity();
    if (turned_deg < settled_deg) return;
  }
}

void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views) {
  const Target target(image, surface);
  for (int round = 0; round < most_rounds; ++round) {
    if (step_all(target, views) < settled_deg) return;
  }
}

}  // namespace rva
