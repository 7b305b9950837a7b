// How well two views agree once one is moved onto the other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "cloud/alignment.hpp"
#include "cloud/planar_patches.hpp"

namespace rva {

/// Samples' positions, so many at once, a coordinate each: what vector instructions take.
struct SampleBlock {
  static constexpr Eigen::Index most = 64;
  using Numbers = Eigen::Array<float, most, 1>;
  std::array<Numbers, 3> position_m;
  Eigen::Index count = 0;  ///< behind these, positions are none
};

/// Two views, and samples of them.
struct ViewPair {
  /// @param every so many patches a sample is taken of, along rows and columns
  ViewPair(const PlanarPatches& initial_patches, const PlanarPatches& final_patches, int every);

  const PlanarPatches& initial;
  const PlanarPatches& final;
  std::vector<SurfaceSample> initial_samples;
  std::vector<SurfaceSample> final_samples;
  std::vector<SampleBlock> initial_blocks;  ///< of the same samples
  std::vector<SampleBlock> final_blocks;
};

/// Sums over samples of either view held against the planes of the other.
struct Agreement {
  AlignmentInformation information = AlignmentInformation::Zero();  ///< of weighted residuals
  AlignmentStep gradient = AlignmentStep::Zero();                   ///< of half the squares, weighted
  double samples = 0.0;
  double compared = 0.0;  ///< the ones that fall onto a plane of the other view
  double agreeing = 0.0;  ///< sum of weights
  double squares = 0.0;   ///< of residuals, weighted
  double in_front = 0.0;  ///< without a weight, where the other view saw through: impossible without a change

  /// What lies on the other view's surfaces, less what lies where it saw through, to which more weight is
  /// given; of all samples.
  [[nodiscard]] double score() const;
};

/// What final_on_initial() and initial_on_final() say of all samples, summed up; in single precision.
/// @param reach_px residuals from which on a sample has no say
[[nodiscard]] Agreement agreement(const ViewPair& views, const Alignment& alignment, double reach_px);

}  // namespace rva
