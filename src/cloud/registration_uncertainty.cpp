#include "cloud/registration_uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/quantile.hpp"

namespace rva {
namespace {

// What all tiles have in common, no scatter shows: on simulated wings errors are three times as large.
constexpr double shared = 10.0;
constexpr int tile_columns = 6;
constexpr int tile_rows = 4;

/// Sums by tile of the camera that saw the samples.
class Tiles {
 public:
  void add(const SurfacePoint& point, const Intrinsics& camera, const AlignmentResidual& residual,
           double weight) {
    const Eigen::Vector2d pixel = camera.project(point.position_m);
    const auto tile = [](double position, int size, int count) {
      return std::clamp(static_cast<int>(position / size * count), 0, count - 1);
    };
    const int column = tile(pixel.x(), camera.width, tile_columns);
    const int row = tile(pixel.y(), camera.height, tile_rows);
    gradients_.at(static_cast<std::size_t>(row * tile_columns + column)) +=
        weight * residual.px * residual.by_step;
    const AlignmentInformation cross = residual.by_step * residual.by_step_of_own.transpose();
    held_ += 0.5 * weight * (cross + cross.transpose());
  }

  [[nodiscard]] AlignmentInformation scatter() const {
    AlignmentInformation sum = AlignmentInformation::Zero();
    for (const AlignmentStep& gradient : gradients_) sum += gradient * gradient.transpose();
    return sum;
  }
  [[nodiscard]] const AlignmentInformation& held() const { return held_; }

 private:
  std::array<AlignmentStep, static_cast<std::size_t>(tile_columns* tile_rows)> gradients_ = [] {
    std::array<AlignmentStep, static_cast<std::size_t>(tile_columns * tile_rows)> zeros;
    zeros.fill(AlignmentStep::Zero());
    return zeros;
  }();
  AlignmentInformation held_ = AlignmentInformation::Zero();
};

double median_distance_m(const std::vector<SurfacePoint>& points) {
  std::vector<double> distances_m;
  for (const SurfacePoint& point : points) distances_m.push_back(point.position_m.z());
  return distances_m.empty() ? 1.0 : quantile(distances_m, 0.5);
}

// Rotations in metres at that distance, and so is the offset, so that all directions compare.
AlignmentStep scales(double distance_m, double disparity_m_px) {
  AlignmentStep by;
  by << distance_m, distance_m, distance_m, 1.0, 1.0, 1.0, distance_m * distance_m / disparity_m_px;
  return by;
}

}  // namespace

RegistrationUncertainty uncertainty(const ViewPair& views, const Alignment& alignment, double reach_px) {
  Tiles of_final;
  Tiles of_initial;
  AlignmentResidual residual;
  for (const SurfacePoint& point : views.final_points) {
    if (!final_on_initial(point, views.initial, alignment, residual)) continue;
    of_final.add(point, views.final.camera(), residual, weight_of(residual.px, reach_px));
  }
  const Transform final_from_initial = alignment.initial_from_final.inverse();
  for (const SurfacePoint& point : views.initial_points) {
    if (!initial_on_final(point, views.final, alignment, final_from_initial, residual)) continue;
    of_initial.add(point, views.initial.camera(), residual, weight_of(residual.px, reach_px));
  }
  const double distance_m = median_distance_m(views.final_points);
  const AlignmentStep by = scales(distance_m, views.final.disparity_m_px());
  AlignmentInformation held = of_final.held() + of_initial.held();
  // The offset is no stranger: a warm camera drifts by a tenth of a pixel.
  constexpr double usual_offset_px = 0.1;
  constexpr double pattern_px = 0.15;
  held(6, 6) += pattern_px * pattern_px / (usual_offset_px * usual_offset_px);
  held = by.cwiseInverse().asDiagonal() * held * by.cwiseInverse().asDiagonal();
  // The same surfaces are sampled in both views: each says the same twice.
  const AlignmentInformation scatter =
      2.0 * (by.cwiseInverse().asDiagonal() * (of_final.scatter() + of_initial.scatter()) *
             by.cwiseInverse().asDiagonal());
  const Eigen::SelfAdjointEigenSolver<AlignmentInformation> directions(held);
  // A direction that nothing holds is as uncertain as a metre.
  constexpr double least = 1e-9;
  AlignmentInformation inverse = AlignmentInformation::Zero();
  AlignmentInformation free = AlignmentInformation::Zero();
  const double floor = std::max(least, 1e-4 * directions.eigenvalues().maxCoeff());
  for (int k = 0; k < 7; ++k) {
    const AlignmentStep direction = directions.eigenvectors().col(k);
    const double value = directions.eigenvalues()[k];
    if (value > floor)
      inverse += direction * direction.transpose() / value;
    else
      free += direction * direction.transpose();
  }
  const AlignmentInformation covariance = shared * inverse * scatter * inverse + free;
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> worst(PoseCovariance(covariance.topLeftCorner<6, 6>()));
  RegistrationUncertainty result;
  result.distance_m = distance_m;
  result.worst_m = std::sqrt(std::max(0.0, worst.eigenvalues()[5]));
  result.worst = worst.eigenvectors().col(5);
  const auto unscaled = by.head<6>().cwiseInverse().asDiagonal();
  result.covariance = unscaled * covariance.topLeftCorner<6, 6>() * unscaled;
  return result;
}

}  // namespace rva
