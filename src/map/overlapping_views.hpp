// Views of one scene that see each other's surfaces, and how well their poses agree.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <vector>

#include "cloud/agreement.hpp"
#include "cloud/planar_patches.hpp"
#include "geometry/transform.hpp"
#include "map/map_view.hpp"

namespace rva {

/// A small motion of a view's camera in its own frame, rotation vector (rad) before translation (m): the pose
/// becomes world_from_camera * motion.
using CameraMotion = Eigen::Matrix<double, 6, 1>;

[[nodiscard]] Transform transform_of(const CameraMotion& motion);
/// The motion that takes the first pose to the second.
[[nodiscard]] CameraMotion motion_between(const Transform& first, const Transform& second);

/// Two views by number; the first is the lower one.
struct ViewNumbers {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// How well a view lies on the surfaces that other views have seen.
struct ViewAgreement {
  int neighbours = 0;     ///< other views that share surfaces with it
  double compared = 0.0;  ///< samples of all its pairs that fall onto the other view's planes
  double agreeing = 0.0;  ///< of these, the sum of weights
  double squares = 0.0;   ///< of residuals, weighted

  /// What of the compared samples lies on the same surfaces.
  [[nodiscard]] double share() const { return agreeing / std::max(1.0, compared); }
  /// Root mean square of what does.
  [[nodiscard]] double residual_px() const { return std::sqrt(squares / std::max(1.0, agreeing)); }
};

/// What all pairs say of small motions of all cameras, six rows each, in units of a residual's variance.
struct PosesAgreement {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;  ///< of half the weighted squares
  std::vector<ViewAgreement> views;
};

/// How far to look, and how finely.
struct PosesDescent {
  int step_px = 8;      ///< of the grid of patches: 8 or 4
  int every = 4;        ///< so many patches a sample is taken of
  double reach_px = 1;  ///< residuals from which on a sample has no say
};

/// Planar patches of all views.
class OverlappingViews {
 public:
  explicit OverlappingViews(std::span<const MapView> views);

  [[nodiscard]] std::size_t size() const { return coarse_.size(); }

  /// All pairs that share a tenth of their surfaces.
  [[nodiscard]] std::vector<ViewNumbers> pairs(std::span<const Transform> world_from_camera) const;

  /// Residuals as in cloud/agreement.hpp, of both views of each pair. Residuals of neighbours err together,
  /// so the information is less than their number says.
  [[nodiscard]] PosesAgreement agreement(std::span<const Transform> world_from_camera,
                                         std::span<const ViewNumbers> pairs,
                                         const PosesDescent& descent) const;

 private:
  std::deque<PlanarPatches> coarse_;
  std::deque<PlanarPatches> fine_;
};

}  // namespace rva
