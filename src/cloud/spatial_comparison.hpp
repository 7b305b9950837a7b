// What changed between two views that lie over each other.
#pragma once

#include "cloud/depth_view.hpp"
#include "cloud/registration.hpp"
#include "detect/calibrated/calibrated.hpp"

namespace rva {

/// Change by free space, judged as the calibrated detector judges change.
/// @param registration to be trusted
/// @param unit_m       metres of one step of the depth images
[[nodiscard]] CalibratedComparison compare_spatial(const DepthView& initial, const DepthView& final,
                                                   const Registration& registration, double unit_m,
                                                   const CalibratedOptions& options);

}  // namespace rva
