// What a camera measured from one pose, for comparison with what it measured from another.
#pragma once

#include "capture/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// The mean over the frames of a capture, in disparity: there a stereo camera's noise is even, and a plane is
/// linear in the pixel's coordinates.
struct DepthView {
  Intrinsics camera;          ///< without lens distortion
  StereoScale stereo;         ///< between depth and disparity
  Image<float> disparity_px;  ///< mean; 0 where the camera saw nothing in half of the frames, or where
                              ///< depth jumps between matches
  Image<float> deviation_px;  ///< of one frame, over time; 0 for single frames

  /// Whether pixel i has a disparity.
  [[nodiscard]] bool seen(std::size_t i) const { return disparity_px[i] > 0.0F; }
};

/// @param camera of the statistics' size
/// @throws Error when the camera's lens bends rays: a plane is no plane then
[[nodiscard]] DepthView depth_view(const DepthStatistics& depth, const Intrinsics& camera,
                                   const StereoScale& stereo);

/// The view of all depth images of a capture. @throws Error when one cannot be read, or as above
[[nodiscard]] DepthView depth_view(const Capture& capture);

}  // namespace rva
