#include "map/joint_turn.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/quantile.hpp"
#include "core/units.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

// Two degrees move the picture of an imager with a narrow view by 22 px, which the coarsest one bridges.
constexpr std::array<double, 4> smoothings_px{8.0, 4.0, 2.0, 1.0};
constexpr int step_px = 2;  // neighbouring pixels share most of the smoothing
constexpr double steepest_share = 0.3;

/// A picture without the noise of single pixels and without what varies over wide distances.
class Band {
 public:
  Band(const Image<float>& picture, double smoothing_px, const Intrinsics& camera)
      : camera_(camera), image_(picture.width(), picture.height()) {
    constexpr double wide = 4.0;
    const int wide_px = 2 * static_cast<int>(wide * smoothing_px) + 1;
    cv::Mat target = as_mat(image_);
    cv::GaussianBlur(as_mat(picture), target, {}, smoothing_px);
    cv::Mat slow;
    cv::blur(target, slow, {wide_px, wide_px});
    target -= slow;
  }

  /// Empty for a point that is not well inside the picture.
  [[nodiscard]] std::optional<float> at(const Transform& imager_from_point,
                                        const Eigen::Vector3d& point_m) const {
    constexpr double border_px = 4.0;
    const Eigen::Vector3d point = imager_from_point * point_m;
    if (point.z() <= 0.0) return std::nullopt;
    const Eigen::Array2d at = camera_.project(point).array();
    const Eigen::Array2d last(image_.width() - 1 - border_px, image_.height() - 1 - border_px);
    if (!((at >= border_px).all() && (at <= last).all())) return std::nullopt;  // also not a number
    return cubic_at(image_, at.matrix().cast<float>());
  }

 private:
  const Intrinsics& camera_;
  Image<float> image_;
};

/// The imager after a small turn about each axis, in both directions.
struct SmallTurns {
  double turn_deg = 0.0;
  std::array<Transform, 3> after;
  std::array<Transform, 3> before;

  /// By central differences; empty where one of them is outside the picture.
  [[nodiscard]] std::optional<Eigen::Vector3f> slope_per_deg(const Band& band,
                                                             const Eigen::Vector3d& point_m) const {
    Eigen::Vector3f slope;
    for (std::size_t k = 0; k < after.size(); ++k) {
      const std::optional<float> more = band.at(after.at(k), point_m);
      const std::optional<float> less = band.at(before.at(k), point_m);
      if (!more || !less) return std::nullopt;
      slope[static_cast<Eigen::Index>(k)] = (*more - *less) / static_cast<float>(2.0 * turn_deg);
    }
    return slope;
  }
};

double tukey(float residual, float limit) {
  const double share = static_cast<double>(std::abs(residual) / limit);
  return share < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
}

double correlation_of(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  const auto sizes = static_cast<double>(a.norm() * b.norm());
  return sizes > 0.0 ? static_cast<double>(a.dot(b)) / sizes : 0.0;
}

Eigen::VectorXf as_vector(const std::vector<float>& values) {
  return Eigen::VectorXf::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

struct JointTurnGauge::Estimate {
  Eigen::Vector3d turn_deg = Eigen::Vector3d::Zero();
  double gain = 1.0;  // of the later picture's brightness
  double correlation = 0.0;
};

JointTurnGauge::JointTurnGauge(const PanTiltChain& chain, const PanTilt& joints, const PictureImager& imager,
                               const ReferenceSurface& surface, const Image<float>& first)
    : chain_(chain),
      joints_(joints),
      imager_(imager),
      camera_from_foot_(foot_from_camera(chain, joints).inverse()) {
  assert(!surface.inverse_depth_per_m.empty());
  const JointTwists twists = joint_twists(chain, joints);
  const Eigen::Vector3d pan_axis = twists.pan.head<3>();
  rest_axis_ = pan_axis.cross(twists.tilt.head<3>()).normalized();
  for (const double smoothing_px : smoothings_px) levels_.push_back(level_of(smoothing_px, surface, first));
}

// From the depth imager's frame at the first picture.
Transform JointTurnGauge::imager_from_first(const Eigen::Vector3d& turn_deg) const {
  const PanTilt joints{joints_.pan_deg + turn_deg.x(), joints_.tilt_deg + turn_deg.y()};
  const Transform first_from_camera = camera_from_foot_ * foot_from_camera(chain_, joints) *
                                      Eigen::AngleAxisd(radians(turn_deg.z()), rest_axis_);
  return imager_.from_depth * first_from_camera.inverse();
}

JointTurnGauge::Level JointTurnGauge::level_of(double smoothing_px, const ReferenceSurface& surface,
                                               const Image<float>& first) const {
  constexpr double turn_deg_per_px = 0.05;  // moves the picture by about half of what it is smoothed over
  const Band band(first, smoothing_px, imager_.camera);
  SmallTurns turns{turn_deg_per_px * smoothing_px, {}, {}};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d turn_deg = turns.turn_deg * Eigen::Vector3d::Unit(k);
    turns.after.at(static_cast<std::size_t>(k)) = imager_from_first(turn_deg);
    turns.before.at(static_cast<std::size_t>(k)) = imager_from_first(-turn_deg);
  }
  const auto steepness = [](const Sample& sample) { return sample.slope_per_deg.head<2>().norm(); };
  Level level{smoothing_px, {}};
  std::vector<float> steepnesses;
  for (int v = 0; v < surface.camera.height; v += step_px) {
    for (int u = 0; u < surface.camera.width; u += step_px) {
      const double depth_m = 1.0 / static_cast<double>(surface.inverse_depth_per_m(u, v));
      const Eigen::Vector3d point_m = surface.camera.deproject({u, v}, depth_m);
      const std::optional<float> brightness = band.at(imager_.from_depth, point_m);
      const std::optional<Eigen::Vector3f> slope = turns.slope_per_deg(band, point_m);
      if (!brightness || !slope) continue;
      level.samples.push_back({point_m, *brightness, *slope});
      steepnesses.push_back(steepness(level.samples.back()));
    }
  }
  if (level.samples.empty()) return level;
  const float least = quantile(steepnesses, 1.0 - steepest_share);
  std::erase_if(level.samples, [&](const Sample& sample) { return steepness(sample) < least; });
  return level;
}

/// The samples that a later picture shows, after the estimated turn is undone.
struct JointTurnGauge::Comparison {
  Comparison(const Level& level, const Band& band, const Transform& imager_from_point) {
    for (const Sample& sample : level.samples) {
      const std::optional<float> brightness = band.at(imager_from_point, sample.point_m);
      if (!brightness) continue;
      samples.push_back(&sample);
      first.push_back(sample.brightness);
      later.push_back(*brightness);
    }
  }

  [[nodiscard]] float residual(std::size_t i, double gain) const {
    return later[i] - static_cast<float>(gain) * first[i];
  }

  /// The limit of Tukey's weights, from the spread of the residuals.
  [[nodiscard]] float limit(double gain) const {
    constexpr float tukey_deviations = 4.685F;
    constexpr float least_limit = 1e-6F;  // pictures without noise agree exactly
    std::vector<float> sizes;
    for (std::size_t i = 0; i < samples.size(); ++i) sizes.push_back(std::abs(residual(i, gain)));
    return std::max(tukey_deviations * robust_deviation(sizes), least_limit);
  }

  /// By how much the three angles (degrees) and the gain are too large.
  // Equation 87 of docs/math.md.
  [[nodiscard]] Eigen::Vector4d excess(double gain) const {
    const float tukey_limit = limit(gain);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const float r = residual(i, gain);
      const double weight = tukey(r, tukey_limit);
      Eigen::Vector4d slope;
      slope << samples[i]->slope_per_deg.cast<double>(), -static_cast<double>(first[i]);
      normal.noalias() += weight * slope * slope.transpose();
      right += weight * static_cast<double>(r) * slope;
    }
    return normal.ldlt().solve(right);
  }

  std::vector<const Sample*> samples;
  std::vector<float> first;
  std::vector<float> later;
};

void JointTurnGauge::improve(const Level& level, const Image<float>& picture, Estimate& estimate) const {
  constexpr int most_rounds = 12;
  constexpr double settled_deg = 0.0002;
  const Band band(picture, level.smoothing_px, imager_.camera);
  for (int round = 0; round < most_rounds; ++round) {
    const Comparison comparison(level, band, imager_from_first(estimate.turn_deg));
    estimate.correlation = correlation_of(as_vector(comparison.first), as_vector(comparison.later));
    if (comparison.samples.empty()) return;
    const Eigen::Vector4d excess = comparison.excess(estimate.gain);
    if (!excess.allFinite()) return;  // nothing in the pictures shows a turn
    estimate.turn_deg -= excess.head<3>();
    estimate.gain -= excess.w();
    if (excess.head<3>().norm() < settled_deg) return;
  }
}

JointTurn JointTurnGauge::turn_to(const Image<float>& picture) const {
  Estimate estimate;
  for (const Level& level : levels_) improve(level, picture, estimate);
  return {estimate.turn_deg.x(), estimate.turn_deg.y(), estimate.turn_deg.z(), estimate.correlation};
}

}  // namespace rva
