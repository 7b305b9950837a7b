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

constexpr double smoothing_px = 0.8;
constexpr int wide_px = 61;
constexpr int border_px = 3;
constexpr float tukey_log = 0.4F;
constexpr int most_rounds = 12;
constexpr double settled_deg = 0.002;

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

const auto narrow = [](const cv::Mat& from, cv::Mat& to) { cv::GaussianBlur(from, to, {}, smoothing_px); };
const auto wide = [](const cv::Mat& from, cv::Mat& to) { cv::blur(from, to, {wide_px, wide_px}); };

cv::Mat as_weights(const cv::Mat& mask) {
  cv::Mat weights;
  mask.convertTo(weights, CV_32F, 1.0 / mask_set);
  return weights;
}

/// What views are laid upon.
class Target {
 public:
  Target(const DotFreeImage& image, const ReferenceSurface& surface)
      : surface_(surface),
        filled_(without_gaps(image)),
        weights_(as_weights(as_mat(image.samples) > 0)),
        smooth_(masked_mean(as_mat(filled_), weights_, narrow, as_mat(filled_))) {
    constexpr double per_px = 1.0 / 8.0;  // of Sobel's sums
    cv::Sobel(smooth_, along_u_, CV_32F, 1, 0, 3, per_px);
    cv::Sobel(smooth_, along_v_, CV_32F, 0, 1, 3, per_px);
    choose_pixels();
  }

  /// The view's pose after one step.
  [[nodiscard]] Transform step(const InfraredView& view) const {
    const Warp warp(surface_, view.view_from_reference);
    const Mask clear = warp.clear_of(view.dots);
    const cv::Mat clear_weights = as_weights(as_mat(clear));
    const cv::Mat weights = clear_weights.mul(weights_);
    const Image<float> image = warp.image(view.log_image);
    const cv::Mat smooth = masked_mean(as_mat(image), clear_weights, narrow, smooth_);
    const cv::Mat difference = smooth - smooth_;
    const cv::Mat level = masked_mean(difference, weights, wide, cv::Mat::zeros(difference.size(), CV_32F));
    return turned(view.view_from_reference, -turn_between(difference - level, weights));
  }

 private:
  static Transform turned(const Transform& view_from_reference, const Eigen::Vector3d& by_rad) {
    const double angle = by_rad.norm();
    return angle > 0.0 ? Transform(Eigen::AngleAxisd(angle, by_rad / angle) * view_from_reference)
                       : view_from_reference;
  }

  // Where the image is flat, nothing is learnt about the pose.
  void choose_pixels() {
    constexpr double most_share = 0.3;
    std::vector<float> steepness;
    for (int v = border_px; v < smooth_.rows - border_px; ++v) {
      for (int u = border_px; u < smooth_.cols - border_px; ++u) {
        if (weights_.at<float>(v, u) > 0.0F) steepness.push_back(steepness_at(u, v));
      }
    }
    if (steepness.empty()) return;
    const float least = quantile(steepness, 1.0 - most_share);
    for (int v = border_px; v < smooth_.rows - border_px; ++v) {
      for (int u = border_px; u < smooth_.cols - border_px; ++u) {
        if (weights_.at<float>(v, u) > 0.0F && steepness_at(u, v) >= least) pixels_.emplace_back(u, v);
      }
    }
  }
  [[nodiscard]] float steepness_at(int u, int v) const {
    return std::hypot(along_u_.at<float>(v, u), along_v_.at<float>(v, u));
  }

  // How the smooth image at a pixel changes with a turn of the camera.
  [[nodiscard]] Eigen::Vector3d slope(const cv::Point& pixel) const {
    const Intrinsics& camera = surface_.camera;
    const double x = (pixel.x - camera.cx) / camera.fx;
    const double y = (pixel.y - camera.cy) / camera.fy;
    const double gu = camera.fx * static_cast<double>(along_u_.at<float>(pixel));
    const double gv = camera.fy * static_cast<double>(along_v_.at<float>(pixel));
    return {-x * y * gu - (1.0 + y * y) * gv, (1.0 + x * x) * gu + x * y * gv, x * gv - y * gu};
  }

  [[nodiscard]] Eigen::Vector3d turn_between(const cv::Mat& residual, const cv::Mat& weights) const {
    Eigen::Matrix3d normal = prior * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const cv::Point& pixel : pixels_) {
      const float r = residual.at<float>(pixel);
      if (weights.at<float>(pixel) < 0.5F || std::abs(r) >= tukey_log) continue;
      const auto share = static_cast<double>(r / tukey_log);
      const double weight = (1.0 - share * share) * (1.0 - share * share);
      const Eigen::Vector3d j = slope(pixel);
      normal.noalias() += weight * j * j.transpose();
      right += weight * static_cast<double>(r) * j;
    }
    // The gradients' own noise makes the image seem steeper than it is, and each step fall short.
    constexpr double gain = 1.3;
    return gain * normal.ldlt().solve(right);
  }

  const ReferenceSurface& surface_;
  Image<float> filled_;
  cv::Mat weights_;
  cv::Mat smooth_;
  cv::Mat along_u_;
  cv::Mat along_v_;
  std::vector<cv::Point> pixels_;
  // What is known of a turn beforehand, so that images that show nothing turn nothing: a sixth of a degree,
  // in residuals of which ten neighbours share the noise.
  static constexpr double usual_turn_rad = 0.16 * std::numbers::pi / 180.0;
  static constexpr double noise_log = 0.02;
  static constexpr double prior = 10.0 * noise_log * noise_log / (usual_turn_rad * usual_turn_rad);
};

std::vector<Transform> stepped(const Target& target, const std::vector<InfraredView>& views) {
  std::vector<Transform> poses(views.size());
  parallel_bands(static_cast<int>(views.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      poses[k] = target.step(views[k]);
  });
  return poses;
}

// @return true when no view turned any more
bool take(const std::vector<Transform>& poses, std::vector<InfraredView>& views) {
  double most_deg = 0.0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const Transform motion = poses[k] * views[k].view_from_reference.inverse();
    most_deg = std::max(most_deg, Eigen::AngleAxisd(motion.linear()).angle() * 180.0 / std::numbers::pi);
    views[k].view_from_reference = poses[k];
  }
  return most_deg < settled_deg;
}

}  // namespace

void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views) {
  for (int round = 0; round < most_rounds; ++round) {
    const DotFreeImage image = fuse(surface, views);
    std::vector<Transform> poses = stepped(Target(image, surface), views);
    const Transform reference_from_first = poses.front().inverse();
    for (Transform& pose : poses) pose = pose * reference_from_first;
    if (take(poses, views)) return;
  }
}

void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views) {
  const Target target(image, surface);
  for (int round = 0; round < most_rounds; ++round) {
    if (take(stepped(target, views), views)) return;
  }
}

}  // namespace rva
