#include "cloud/spatial_comparison.hpp"

#include "cloud/free_space.hpp"

namespace rva {
namespace {

// Of simulated wings, one to three captures a side (docs/spatial.md). Depth that went missing is no evidence
// from another place.
constexpr UsualSlopes slopes_of_moved_cameras{{0.9, 0.45}, {1.5, 0.8}};

}  // namespace

CalibratedComparison compare_spatial(const DepthView& initial, const DepthView& final,
                                     const Registration& registration, double unit_m,
                                     const CalibratedOptions& options) {
  return compare_calibrated(
      free_space_change(initial, final, registration.initial_from_final, registration.offset_px),
      final.disparity_m_px / unit_m, final.disparity_m_px, slopes_of_moved_cameras, options);
}

}  // namespace rva
