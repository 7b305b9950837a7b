#include "infrared/infrared_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "core/quantile.hpp"
#include "core/units.hpp"
#include "depth/mat_view.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

constexpr double smoothing_px = 0.8;
constexpr int wide_px = 61;
constexpr int border_px = 3;
constexpr float tukey_log = 0.2F;
constexpr double settled_rad = radians(0.002);

/// The weighted mean around each pixel; `missing` where there is hardly any weight.
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

/// The smoothed image of a view without its dots, computed once for all steps.
struct SmoothView {
  SmoothView() = default;
  explicit SmoothView(const InfraredView& view) : clear(view.dots.width(), view.dots.height()) {
    const cv::Mat between_dots = as_mat(view.dots) == 0;
    const cv::Mat mean =
        masked_mean(as_mat(view.log_image), as_weights(between_dots), narrow, as_mat(view.log_image));
    cv::Mat target = as_mat(clear);
    cv::erode(between_dots, target, cv::Mat::ones(3, 3, CV_8U));  // beside a dot, the mean is biased
    image = Image<float>(clear.width(), clear.height());
    cv::Mat image_target = as_mat(image);
    mean.copyTo(image_target);
  }
  // True if the four surrounding pixels lie within the image and none is under a dot.
  [[nodiscard]] bool shows(const Eigen::Vector2f& at) const {
    if (!(at.x() >= 0.0F && at.y() >= 0.0F)) return false;
    const int u = static_cast<int>(at.x());
    const int v = static_cast<int>(at.y());
    return u + 1 < clear.width() && v + 1 < clear.height() && clear(u, v) != 0 && clear(u + 1, v) != 0 &&
           clear(u, v + 1) != 0 && clear(u + 1, v + 1) != 0;
  }

  Mask clear;
  Image<float> image;
};

std::vector<SmoothView> smooth_views(const std::vector<InfraredView>& views) {
  std::vector<SmoothView> smooth(views.size());
  parallel_bands(static_cast<int>(views.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      smooth[k] = SmoothView(views[k]);
  });
  return smooth;
}

/// The image to which views are registered.
class Target {
 public:
  Target(const DotFreeImage& image, const ReferenceSurface& surface)
      : surface_(surface), weights_(as_weights(as_mat(image.samples) > 0)) {
    constexpr double per_px = 1.0 / 8.0;  // scale of Sobel's sums
    const Image<float> filled = without_gaps(image);
    smooth_ = masked_mean(as_mat(filled), weights_, narrow, as_mat(filled));
    cv::Sobel(smooth_, along_u_, CV_32F, 1, 0, 3, per_px);
    cv::Sobel(smooth_, along_v_, CV_32F, 0, 1, 3, per_px);
    choose_pixels();
  }

  /// The pose of the view after one step. A second step towards the same image would be impeded by the noise
  /// of the view itself, which is part of that image.
  [[nodiscard]] Transform step(const SmoothView& smooth, const InfraredView& view) const {
    return turned(view.view_from_reference, -turn_between(smooth, view));
  }

 private:
  static Transform turned(const Transform& view_from_reference, const Eigen::Vector3d& by_rad) {
    const double angle = by_rad.norm();
    return angle > 0.0 ? Transform(Eigen::AngleAxisd(angle, by_rad / angle) * view_from_reference)
                       : view_from_reference;
  }

  // Chooses the steepest pixels, since flat parts of the image do not constrain the pose.
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

  // Derivative of the smoothed image at a pixel by a rotation of the camera.
  // Equation 56 of docs/math.md.
  [[nodiscard]] Eigen::Vector3d slope(const cv::Point& pixel) const {
    const Intrinsics& camera = surface_.camera;
    const double x = (pixel.x - camera.cx) / camera.fx;
    const double y = (pixel.y - camera.cy) / camera.fy;
    const double gu = camera.fx * static_cast<double>(along_u_.at<float>(pixel));
    const double gv = camera.fy * static_cast<double>(along_v_.at<float>(pixel));
    return {-x * y * gu - (1.0 + y * y) * gv, (1.0 + x * x) * gu + x * y * gv, x * gv - y * gu};
  }

  // Equation 57 of docs/math.md.
  [[nodiscard]] Eigen::Vector3d turn_between(const SmoothView& smooth, const InfraredView& view) const {
    const ViewOfSurface seen(surface_, view.view_from_reference, view.camera.value_or(surface_.camera));
    cv::Mat difference = cv::Mat::zeros(smooth_.size(), CV_32F);
    cv::Mat compared = cv::Mat::zeros(smooth_.size(), CV_32F);
    for (const cv::Point& pixel : pixels_) {
      const Eigen::Vector2f at = seen.seen_at(pixel.x, pixel.y);
      if (!smooth.shows(at)) continue;
      difference.at<float>(pixel) = cubic_at(smooth.image, at) - smooth_.at<float>(pixel);
      compared.at<float>(pixel) = 1.0F;
    }
    const cv::Mat level = masked_mean(difference, compared, wide, cv::Mat::zeros(difference.size(), CV_32F));
    Eigen::Matrix3d normal = damping * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const cv::Point& pixel : pixels_) {
      const float r = difference.at<float>(pixel) - level.at<float>(pixel);
      if (compared.at<float>(pixel) == 0.0F || std::abs(r) >= tukey_log) continue;
      const auto share = static_cast<double>(r / tukey_log);
      const double weight = (1.0 - share * share) * (1.0 - share * share);
      const Eigen::Vector3d j = slope(pixel);
      normal.noalias() += weight * j * j.transpose();
      right += weight * static_cast<double>(r) * j;
    }
    // Compensates for noise in the gradients, which makes the image seem steeper than it is and shortens
    // each step.
    constexpr double gain = 1.3;
    return gain * normal.ldlt().solve(right);
  }

  const ReferenceSurface& surface_;
  cv::Mat weights_;
  cv::Mat smooth_;
  cv::Mat along_u_;
  cv::Mat along_v_;
  std::vector<cv::Point> pixels_;
  // Damping of each step, which keeps poses unchanged if images show nothing: the information of a prior of
  // the rotation with a standard deviation of a sixth of a degree, for residuals whose noise ten neighbouring
  // pixels share.
  static constexpr double usual_turn_rad = radians(0.16);
  static constexpr double noise_log = 0.02;
  static constexpr double damping = 10.0 * noise_log * noise_log / (usual_turn_rad * usual_turn_rad);
};

std::vector<Transform> stepped(const Target& target, const std::vector<SmoothView>& smooth,
                               const std::vector<InfraredView>& views) {
  std::vector<Transform> poses(views.size());
  parallel_bands(static_cast<int>(views.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      poses[k] = target.step(smooth[k], views[k]);
  });
  return poses;
}

// Applies the poses.
// @return true when no view was rotated by more than settled_rad
bool take(const std::vector<Transform>& poses, std::vector<InfraredView>& views) {
  double most_rad = 0.0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const Transform motion = poses[k] * views[k].view_from_reference.inverse();
    most_rad = std::max(most_rad, Eigen::AngleAxisd(motion.linear()).angle());
    views[k].view_from_reference = poses[k];
  }
  return most_rad < settled_rad;
}

}  // namespace

void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views) {
  const std::vector<SmoothView> smooth = smooth_views(views);
  const Transform first = views.front().view_from_reference;
  for (int round = 0; round < usual_rounds; ++round) {
    std::vector<Transform> poses = stepped(Target(fuse(surface, views), surface), smooth, views);
    const Transform back_to_first = poses.front().inverse() * first;
    for (Transform& pose : poses) pose = pose * back_to_first;
    if (take(poses, views)) return;
  }
}

void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views,
              int most_rounds) {
  const std::vector<SmoothView> smooth = smooth_views(views);
  const Target target(image, surface);
  for (int round = 0; round < most_rounds; ++round) {
    if (take(stepped(target, smooth, views), views)) return;
  }
}

}  // namespace rva
