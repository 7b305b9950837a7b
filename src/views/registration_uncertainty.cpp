#include "views/registration_uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/quantile.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

// Factor for errors common to all tiles, which scatter does not show: on simulated wings, errors are three
// times as large.
constexpr double shared = 10.0;
constexpr std::size_t tile_columns = 6;
constexpr std::size_t tile_rows = 4;

/// Sums for each tile of the image of the camera that saw the samples.
class Tiles {
 public:
  void add(const SurfaceSample& point, const Intrinsics& camera, const AlignmentResidual& residual,
           double weight) {
    const Eigen::Vector2d pixel = camera.project(point.position_m);
    const auto tile = [](double position_px, int size_px, std::size_t count) {
      const double share = std::clamp((position_px + 0.5) / size_px, 0.0, 1.0);
      return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
    };
    const std::size_t column = tile(pixel.x(), camera.width, tile_columns);
    const std::size_t row = tile(pixel.y(), camera.height, tile_rows);
    gradients_.at(row * tile_columns + column) += weight * residual.px * residual.by_step;
    const AlignmentInformation cross = residual.by_step * residual.by_step_of_own.transpose();
    held_ += 0.5 * weight * (cross + cross.transpose());
  }

  // Equation 40 of docs/math.md.
  [[nodiscard]] AlignmentInformation scatter() const {
    AlignmentInformation sum = AlignmentInformation::Zero();
    for (const AlignmentStep& gradient : gradients_) sum += gradient * gradient.transpose();
    return sum;
  }
  [[nodiscard]] const AlignmentInformation& held() const { return held_; }

 private:
  std::vector<AlignmentStep> gradients_ =
      std::vector<AlignmentStep>(tile_columns * tile_rows, AlignmentStep::Zero());
  AlignmentInformation held_ = AlignmentInformation::Zero();
};

double median_distance_m(const std::vector<SurfaceSample>& points) {
  std::vector<double> distances_m;
  for (const SurfaceSample& point : points) distances_m.push_back(point.position_m.z());
  return distances_m.empty() ? 1.0 : quantile(distances_m, 0.5);
}

// Scales rotations and the offset to metres at that distance, so that all directions are comparable.
AlignmentStep scales(double distance_m, const StereoScale& stereo) {
  AlignmentStep by;
  by << distance_m, distance_m, distance_m, 1.0, 1.0, 1.0,
      distance_m * distance_m / stereo.focal_baseline_m_px;
  return by;
}

// Unconstrained directions get a standard deviation of one metre, or of one radian at a distance of
// one metre.
// Equation 41 of docs/math.md.
AlignmentInformation covariance_of(const AlignmentInformation& held, const AlignmentInformation& scatter) {
  constexpr double nothing = 1e-9;
  constexpr double next_to_nothing = 1e-4;  // of the information on the best constrained direction
  const Eigen::SelfAdjointEigenSolver<AlignmentInformation> directions(held);
  const double least = std::max(nothing, next_to_nothing * directions.eigenvalues().maxCoeff());
  AlignmentInformation inverse = AlignmentInformation::Zero();
  AlignmentInformation free = AlignmentInformation::Zero();
  for (Eigen::Index k = 0; k < directions.eigenvalues().size(); ++k) {
    const AlignmentStep direction = directions.eigenvectors().col(k);
    const AlignmentInformation along = direction * direction.transpose();
    const double information = directions.eigenvalues()[k];
    if (information > least)
      inverse += along / information;
    else
      free += along;
  }
  return shared * inverse * scatter * inverse + free;
}

}  // namespace

// Equations 39 to 41 of docs/math.md.
RegistrationUncertainty uncertainty(const ViewPair& views, const Alignment& alignment, double reach_px) {
  Tiles of_final;
  Tiles of_initial;
  AlignmentResidual residual;
  for (const SurfaceSample& point : views.final_samples) {
    if (!final_on_initial(point, views.initial, alignment, residual)) continue;
    of_final.add(point, views.final.camera(), residual, weight_of(residual.px, reach_px));
  }
  const Transform final_from_initial = alignment.initial_from_final.inverse();
  for (const SurfaceSample& point : views.initial_samples) {
    if (!initial_on_final(point, views.final, alignment, final_from_initial, residual)) continue;
    of_initial.add(point, views.initial.camera(), residual, weight_of(residual.px, reach_px));
  }
  RegistrationUncertainty result;
  result.distance_m = median_distance_m(views.final_samples);
  const AlignmentStep unit = scales(result.distance_m, views.final.stereo()).cwiseInverse();
  AlignmentInformation held = of_final.held() + of_initial.held();
  held(6, 6) += offset_prior;
  // Both views sample the same surfaces, so each residual occurs twice, which doubles the scatter.
  const AlignmentInformation scatter = 2.0 * (of_final.scatter() + of_initial.scatter());
  const TwistMatrix covariance = covariance_of(unit.asDiagonal() * held * unit.asDiagonal(),
                                               unit.asDiagonal() * scatter * unit.asDiagonal())
                                     .topLeftCorner<6, 6>();
  const Eigen::SelfAdjointEigenSolver<TwistMatrix> directions(covariance);
  result.worst_m = std::sqrt(std::max(0.0, directions.eigenvalues()[5]));
  result.worst = directions.eigenvectors().col(5);
  const auto metres_to_radians = unit.head<6>().asDiagonal();
  result.covariance = metres_to_radians * covariance * metres_to_radians;
  return result;
}

}  // namespace rva
