#include "views/view_motion.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/blobs.hpp"
#include "depth/mat_view.hpp"
#include "geometry/stereo_scale.hpp"
#include "views/disparity_change.hpp"

namespace rva {
namespace {

constexpr int motion_terms = 6;  // rotation vector, translation
constexpr int drift_terms = 6;   // as in Drift
constexpr int all_terms = motion_terms + drift_terms;
using Terms = Eigen::Matrix<double, all_terms, 1>;
using Information = Eigen::Matrix<double, all_terms, all_terms>;
using MotionTerms = Eigen::Matrix<double, motion_terms, 1>;

constexpr int tile_columns = 12;
constexpr int tile_rows = 8;
constexpr int sampling_px = 3;
constexpr std::size_t least_samples = 300;

/// A pixel that both views saw.
struct Sample {
  Terms by_terms;  ///< derivative of disparity by each term, px
  double change_px = 0.0;
  Eigen::Matrix<double, 2, motion_terms> flow;  ///< derivative of the position in the image by each term, px
  std::size_t tile = 0;
};

/// The smoothed mean of the disparities of both views, and the change between them.
struct SmoothedPair {
  cv::Mat mean_px;
  cv::Mat change_px;
  cv::Mat slope_u;
  cv::Mat slope_v;
  cv::Mat seen;  // set where all of these are based on measurements
};

// Errors due to the projector's pattern stay at the same pixels when the camera turns, and mask the motion.
// Smoothing removes most of them and keeps edges.
constexpr double smoothing_px = 2.0;

cv::Mat smoothed(const cv::Mat& disparity_px, const cv::Mat& weight, const cv::Mat& weight_around) {
  cv::Mat sum;
  cv::GaussianBlur(disparity_px.mul(weight), sum, {}, smoothing_px);
  return sum / weight_around;
}

SmoothedPair smoothed_pair(const DepthView& initial, const DepthView& final) {
  constexpr double least_weight = 0.6;
  const cv::Mat before = as_mat(initial.disparity_px);
  const cv::Mat after = as_mat(final.disparity_px);
  const cv::Mat both = (before > 0.0) & (after > 0.0);
  cv::Mat weight;
  both.convertTo(weight, CV_32F, 1.0 / mask_set);
  cv::Mat around;
  cv::GaussianBlur(weight, around, {}, smoothing_px);
  around = cv::max(around, 1e-3);
  const cv::Mat before_px = smoothed(before, weight, around);
  const cv::Mat after_px = smoothed(after, weight, around);
  SmoothedPair pair;
  pair.mean_px = 0.5 * (before_px + after_px);
  pair.change_px = after_px - before_px;
  const cv::Mat difference = (cv::Mat_<float>(1, 3) << -0.5F, 0.0F, 0.5F);
  cv::filter2D(pair.mean_px, pair.slope_u, CV_32F, difference);
  cv::filter2D(pair.mean_px, pair.slope_v, CV_32F, difference.t());
  cv::erode(around > least_weight, pair.seen, cv::Mat::ones(5, 5, CV_8U));
  return pair;
}

/// Derivative of a point by each term of a small motion: point_after = point + rotation x point
/// + translation.
Eigen::Matrix<double, 3, motion_terms> motions_of(const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 3, motion_terms> moved;
  moved.col(0) << 0.0, -point.z(), point.y();
  moved.col(1) << point.z(), 0.0, -point.x();
  moved.col(2) << -point.y(), point.x(), 0.0;
  moved.rightCols<3>().setIdentity();
  return moved;
}

/// The change of disparity at a pixel due to a motion is the change of the disparity of the surface point
/// minus the slope of disparity times the flow.
/// Equations 48 and 49 of docs/math.md.
Sample sample_at(int u, int v, const SmoothedPair& pair, const Intrinsics& camera,
                 const StereoScale& stereo) {
  const auto disparity_px = static_cast<double>(pair.mean_px.at<float>(v, u));
  const double z_m = stereo.depth_m(disparity_px);
  const Eigen::Vector3d point = camera.deproject({u, v}, z_m);
  const Eigen::Matrix<double, 3, motion_terms> moved = motions_of(point);
  Sample sample;
  sample.flow.row(0) = camera.fx / z_m * (moved.row(0) - point.x() / z_m * moved.row(2));
  sample.flow.row(1) = camera.fy / z_m * (moved.row(1) - point.y() / z_m * moved.row(2));
  sample.by_terms.head<motion_terms>() =
      (-disparity_px / z_m * moved.row(2) -
       static_cast<double>(pair.slope_u.at<float>(v, u)) * sample.flow.row(0) -
       static_cast<double>(pair.slope_v.at<float>(v, u)) * sample.flow.row(1))
          .transpose();
  const double x = static_cast<double>(u) / camera.width - 0.5;
  const double y = static_cast<double>(v) / camera.height - 0.5;
  sample.by_terms.tail<drift_terms>() << 1.0, x, y, x * x, x * y, y * y;
  sample.change_px = static_cast<double>(pair.change_px.at<float>(v, u));
  const auto column = static_cast<std::size_t>(u * tile_columns / camera.width);
  const auto row = static_cast<std::size_t>(v * tile_rows / camera.height);
  sample.tile = row * tile_columns + column;
  return sample;
}

std::vector<Sample> samples_of(const DepthView& initial, const DepthView& final) {
  const SmoothedPair pair = smoothed_pair(initial, final);
  std::vector<Sample> samples;
  for (int v = margin_px; v < final.camera.height - margin_px; v += sampling_px) {
    for (int u = margin_px; u < final.camera.width - margin_px; u += sampling_px) {
      if (pair.seen.at<std::uint8_t>(v, u) != 0)
        samples.push_back(sample_at(u, v, pair, final.camera, final.stereo));
    }
  }
  return samples;
}

double median_change_px(const std::vector<Sample>& samples) {
  std::vector<double> changes_px;
  for (const Sample& sample : samples) changes_px.push_back(sample.change_px);
  return quantile(changes_px, 0.5);
}

double differing_share(const std::vector<Sample>& samples) {
  constexpr double other_surface_px = 1.0;
  const double median_px = median_change_px(samples);
  const auto differing = std::ranges::count_if(samples, [&](const Sample& sample) {
    return std::abs(sample.change_px - median_px) > other_surface_px;
  });
  return static_cast<double>(differing) / static_cast<double>(samples.size());
}

double residual_px(const Sample& sample, const Terms& terms) {
  return sample.change_px - sample.by_terms.dot(terms);
}

/// Motion and drift, with the weights of the samples.
struct Fit {
  Terms terms = Terms::Zero();
  Information information = Information::Zero();
  std::vector<double> weights;
};

// Equation 12 of docs/math.md.
void reweigh(const std::vector<Sample>& samples, Fit& fit) {
  constexpr double tuning = 4.685;  // 95 % of the efficiency of least squares (Beaton and Tukey)
  constexpr double least_reach_px = 0.15;
  std::vector<double> sizes_px;
  for (const Sample& sample : samples) sizes_px.push_back(std::abs(residual_px(sample, fit.terms)));
  const double reach_px = std::max(least_reach_px, tuning * robust_deviation(sizes_px));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = residual_px(samples[i], fit.terms) / reach_px;
    fit.weights[i] = std::abs(share) < 1.0 ? std::pow(1.0 - share * share, 2) : 0.0;
  }
}

// Solves the weighted least squares. Damping keeps unconstrained directions of motion at 0.
void solve(const std::vector<Sample>& samples, Fit& fit) {
  constexpr double damping = 1e-4;
  fit.information.setZero();
  Terms right = Terms::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (fit.weights[i] <= 0.0) continue;
    fit.information.selfadjointView<Eigen::Lower>().rankUpdate(samples[i].by_terms, fit.weights[i]);
    right += fit.weights[i] * samples[i].change_px * samples[i].by_terms;
  }
  fit.information.triangularView<Eigen::StrictlyUpper>() = fit.information.transpose();
  fit.information.diagonal().head<motion_terms>().array() +=
      damping * fit.information.diagonal().head<motion_terms>().mean();
  fit.information.diagonal().array() += 1e-12;
  fit.terms = fit.information.ldlt().solve(right);
}

Fit fit_motion(const std::vector<Sample>& samples) {
  constexpr int rounds = 10;  // leave less than 1e-5 of an error: equation 87 of docs/math.md
  Fit fit;
  fit.weights.assign(samples.size(), 1.0);
  fit.terms[motion_terms] = median_change_px(samples);
  for (int round = 0; round < rounds; ++round) {
    reweigh(samples, fit);
    solve(samples, fit);
  }
  return fit;
}

// Equation 50 of docs/math.md; equation 88 states by how much it is too small.
Eigen::Matrix<double, motion_terms, motion_terms> covariance_of_motion(const std::vector<Sample>& samples,
                                                                       const Fit& fit) {
  std::array<Terms, tile_columns * tile_rows> scores;
  scores.fill(Terms::Zero());
  for (std::size_t i = 0; i < samples.size(); ++i)
    scores.at(samples[i].tile) += fit.weights[i] * residual_px(samples[i], fit.terms) * samples[i].by_terms;
  Information scatter = Information::Zero();
  for (const Terms& score : scores) scatter += score * score.transpose();
  const Information inverse = fit.information.ldlt().solve(Information::Identity());
  return (inverse * scatter * inverse).topLeftCorner<motion_terms, motion_terms>();
}

// Computes the root mean square displacement in the image and its standard error.
// Equation 51 of docs/math.md.
void measure_displacement(const std::vector<Sample>& samples, const Fit& fit, ViewMotion& motion) {
  const MotionTerms terms = fit.terms.head<motion_terms>();
  const auto covariance = covariance_of_motion(samples, fit);
  double squares = 0.0;
  double variance = 0.0;
  for (const Sample& sample : samples) {
    squares += (sample.flow * terms).squaredNorm();
    variance += (sample.flow * covariance * sample.flow.transpose()).trace();
  }
  const auto count = static_cast<double>(samples.size());
  motion.displacement_px = std::sqrt(squares / count);
  motion.uncertainty_px = std::sqrt(std::max(0.0, variance / count));
}

// Derivative of disparity by the motion, without the part that a drift explains as well.
MotionTerms terms_beside_drift(const Sample& sample,
                               const Eigen::Matrix<double, drift_terms, motion_terms>& as_drift) {
  return sample.by_terms.head<motion_terms>() - as_drift.transpose() * sample.by_terms.tail<drift_terms>();
}

// The number of groups of adjacent tiles that contribute a tenth or more of what the best tile contributes.
int groups_of(const std::array<double, tile_columns * tile_rows>& held) {
  constexpr double much = 0.1;
  Mask informative(tile_columns, tile_rows);
  const double most = *std::ranges::max_element(held);
  for (std::size_t tile = 0; tile < held.size(); ++tile)
    informative[tile] = held.at(tile) > much * most ? mask_set : std::uint8_t{0};
  return static_cast<int>(Blobs(informative).count());
}

// Equation 52 of docs/math.md.
void measure_support(const std::vector<Sample>& samples, const Fit& fit, ViewMotion& motion) {
  const Eigen::Matrix<double, drift_terms, motion_terms> as_drift =
      fit.information.bottomRightCorner<drift_terms, drift_terms>().ldlt().solve(
          fit.information.bottomLeftCorner<drift_terms, motion_terms>());
  std::array<double, tile_columns * tile_rows> held{};
  std::array<double, tile_columns * tile_rows> left{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double effect_px = terms_beside_drift(samples[i], as_drift).dot(fit.terms.head<motion_terms>());
    held.at(samples[i].tile) += fit.weights[i] * effect_px * effect_px;
    left.at(samples[i].tile) += fit.weights[i] * std::pow(residual_px(samples[i], fit.terms), 2);
  }
  double sum = 0.0;
  double squares = 0.0;
  double left_by_held = 0.0;
  for (std::size_t tile = 0; tile < held.size(); ++tile) {
    sum += held.at(tile);
    squares += held.at(tile) * held.at(tile);
    if (held.at(tile) > 0.0) left_by_held += held.at(tile) * left.at(tile) / (held.at(tile) + left.at(tile));
  }
  if (sum <= 0.0) return;
  motion.tiles = sum * sum / squares;
  motion.explained = 1.0 - left_by_held / sum;
  motion.groups = groups_of(held);
}

}  // namespace

bool ViewMotion::noticed() const {
  // Captures of one pose show up to 0.12 px and 2.9 standard errors; those of poses 0.05 degrees apart show
  // 0.19 px and at least 7 standard errors (docs/spatial.md).
  constexpr double least_px = 0.12;
  constexpr double least_deviations = 3.5;
  if (displacement_px < least_px || displacement_px < least_deviations * uncertainty_px) return false;
  constexpr double many_tiles = 16.0;
  constexpr int several_groups = 3;
  constexpr double nearly_all = 0.8;
  return tiles >= many_tiles || (groups >= several_groups && explained >= nearly_all);
}

ViewMotion view_motion(const DepthView& initial, const DepthView& final) {
  assert(initial.camera == final.camera);
  ViewMotion motion;
  const std::vector<Sample> samples = samples_of(initial, final);
  if (samples.size() < least_samples) return motion;
  motion.differing = differing_share(samples);
  const Fit fit = fit_motion(samples);
  measure_displacement(samples, fit, motion);
  measure_support(samples, fit, motion);
  return motion;
}

}  // namespace rva
