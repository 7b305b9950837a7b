// How well two views agree once one is moved onto the other.
#pragma once

#include <vector>

#include "cloud/alignment.hpp"
#include "cloud/planar_patches.hpp"

namespace rva {

/// Two views, and samples of them.
struct ViewPair {
  const PlanarPatches& initial;
  const PlanarPatches& final;
  std::vector<SurfacePoint> initial_points;
  std::vector<SurfacePoint> final_points;
};

/// Sums over samples of either view held against the planes of the other.
struct Agreement {
  AlignmentInformation information = AlignmentInformation::Zero();  ///< of weighted residuals
  AlignmentStep gradient = AlignmentStep::Zero();                   ///< of half the squares, weighted
  double samples = 0.0;
  double compared = 0.0;  ///< the ones that fall onto a plane of the other view
  double agreeing = 0.0;  ///< sum of weights
  double in_front = 0.0;  ///< without a weight, where the other view saw through: impossible without a change

  /// What lies on the other view's surfaces, less what lies where it saw through, to which more weight is
  /// given; of all samples.
  [[nodiscard]] double score() const;
};

/// @param reach_px residuals from which on a sample has no say
[[nodiscard]] Agreement agreement(const ViewPair& views, const Alignment& alignment, double reach_px);

}  // namespace rva
