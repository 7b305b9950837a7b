// Overlapping views of one scene, and the residuals of the surfaces that they share.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <vector>

#include "geometry/rigid_motion.hpp"
#include "geometry/transform.hpp"
#include "map/map_view.hpp"
#include "views/normal_equations.hpp"
#include "views/planar_patches.hpp"

namespace rva {

/// A pair of views by their indices; `first` is the lower one.
struct ViewNumbers {
  std::size_t first = 0;   ///< lower index
  std::size_t second = 0;  ///< higher index
};

/// How well the surfaces of a view coincide with those of other views.
struct ViewResiduals {
  int neighbours = 0;     ///< number of other views that share surfaces with it
  double compared = 0.0;  ///< number of samples of all its pairs that fall onto planes of the other view
  double agreeing = 0.0;  ///< sum of the weights of these samples
  double squares = 0.0;   ///< weighted sum of their squared residuals, px^2

  /// Share of the compared samples that lie on the same surfaces.
  [[nodiscard]] double share() const { return agreeing / std::max(1.0, compared); }
  /// Weighted root mean square of the residuals.
  [[nodiscard]] double residual_px() const { return std::sqrt(squares / std::max(1.0, agreeing)); }
};

/// The normal equations of all pairs for small motions of all cameras: a twist for each camera in its own
/// frame, six rows, with residuals divided by their deviation. The moved pose is
/// world_from_camera * exp_of(twist).
struct PoseEquations {
  Eigen::MatrixXd information;       ///< sum over all pairs, six rows and columns per camera
  Eigen::VectorXd gradient;          ///< of half the weighted sum of squares
  std::vector<ViewResiduals> views;  ///< one for each view
};

/// Sampling density and reach of one step of an optimisation.
struct PosesDescent {
  int step_px = 8;      ///< spacing of the grid of patches: 8 or 4
  int every = 4;        ///< one sample is taken per so many patches
  double reach_px = 1;  ///< samples with residuals beyond this have no weight
};

/// Planar patches of all views, at two spacings.
class OverlappingViews {
 public:
  /// @param views need not outlive this object
  explicit OverlappingViews(std::span<const MapView> views);

  /// Number of views.
  [[nodiscard]] std::size_t size() const { return coarse_.size(); }

  /// All pairs of views in which more than a tenth of the samples fall onto planes of the other view.
  [[nodiscard]] std::vector<ViewNumbers> pairs(std::span<const Transform> world_from_camera) const;

  /// Sums the residuals of views/normal_equations.hpp over the pairs. The errors of neighbouring residuals
  /// are correlated, so that the information is reduced accordingly.
  [[nodiscard]] PoseEquations equations(std::span<const Transform> world_from_camera,
                                        std::span<const ViewNumbers> pairs,
                                        const PosesDescent& descent) const;

 private:
  std::deque<PlanarPatches> coarse_;
  std::deque<PlanarPatches> fine_;
};

}  // namespace rva
