// Measures how well two views fit for a given alignment.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "views/alignment.hpp"
#include "views/planar_patches.hpp"

namespace rva {

/// Positions of up to `most` samples, one array per coordinate, for vector instructions.
struct SampleBlock {
  static constexpr Eigen::Index most = 64;  ///< number of samples for which a block has room
  /// One coordinate of all samples.
  using Numbers = Eigen::Array<float, most, 1>;
  std::array<Numbers, 3> position_m;  ///< x, y and z in the camera's frame, metres
  Eigen::Index count = 0;             ///< number of valid positions, at the beginning
};

/// Two views as planar patches, with samples of both.
struct ViewPair {
  /// @param every distance between samples along rows and columns, in patches
  ViewPair(const PlanarPatches& initial_patches, const PlanarPatches& final_patches, int every);

  const PlanarPatches& initial;                ///< must outlive the pair
  const PlanarPatches& final;                  ///< must outlive the pair
  std::vector<SurfaceSample> initial_samples;  ///< of the initial view
  std::vector<SurfaceSample> final_samples;    ///< of the final view
  std::vector<SampleBlock> initial_blocks;     ///< the same samples in blocks
  std::vector<SampleBlock> final_blocks;       ///< the same samples in blocks
};

/// Sums over the samples of either view, compared with the planes of the other.
struct NormalEquations {
  AlignmentInformation information = AlignmentInformation::Zero();  ///< of weighted residuals
  AlignmentStep gradient = AlignmentStep::Zero();                   ///< of half the weighted squares
  double samples = 0.0;                                             ///< number of all samples
  double compared = 0.0;  ///< those that fall onto a plane of the other view
  double agreeing = 0.0;  ///< sum of weights
  double squares = 0.0;   ///< weighted, of residuals
  /// Unweighted number of samples in space that the other view saw through, which only a change explains.
  double in_front = 0.0;

  /// Sum of weights minus a multiple of `in_front`, as a share of all samples.
  [[nodiscard]] double score() const;
};

/// Sums final_on_initial() and initial_on_final() over all samples, in single precision.
/// @param reach_px residuals of this size and above have a weight of 0
[[nodiscard]] NormalEquations normal_equations(const ViewPair& views, const Alignment& alignment,
                                               double reach_px);

}  // namespace rva
