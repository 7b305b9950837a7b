#include "detect/spatial/spatial_comparison.hpp"

#include <utility>

#include "views/free_space.hpp"

namespace rva {

SpatialChange change_from_elsewhere(const DepthView& initial, const DepthView& final,
                                    const Registration& registration, KnownMotion known) {
  return {free_space_change(initial, final, registration.initial_from_final, registration.offset_px),
          known == KnownMotion::bumped ? slopes_of_bumped_cameras : slopes_of_moved_cameras, final.stereo};
}

SpatialChange change_from_same_places(std::vector<PlacedChange> changes, const Intrinsics& camera,
                                      const StereoScale& stereo) {
  DisparityChange fused = fuse(std::move(changes), camera, stereo);
  const PriorSlopes slopes = prior_slopes(fused.frames);
  return {std::move(fused), slopes, stereo};
}

CalibratedComparison compare_spatial(const SpatialChange& change, const CalibratedOptions& options) {
  return compare_calibrated(change.change, change.stereo, change.slopes, options);
}

}  // namespace rva
