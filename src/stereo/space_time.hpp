// Space-time stereo: one surface from all infrared pairs of a dithered side.
//
// Davis, Nehab, Ramamoorthi and Rusinkiewicz, "Spacetime Stereo", IEEE PAMI 27 (2005): if the pattern moves
// between pairs, windows may be small, since each point is matched in all of them. Here the projector turns
// with the camera, so that in every pair its pattern falls elsewhere on the surface.
#pragma once

#include <span>

#include "depth/image.hpp"
#include "geometry/stereo_scale.hpp"
#include "infrared/reference_surface.hpp"
#include "stereo/plane_sweep.hpp"

namespace rva {

/// The start surface, moved to where it explains the pairs best, and then smoothed by a median of 5 x 5
/// pixels. It is not moved where no pair sees the pixel.
[[nodiscard]] ReferenceSurface refined(const ReferenceSurface& start, const StereoScale& stereo,
                                       std::span<const StereoView> views, const SweepOptions& options);

/// Estimates the surface that explains all pairs best, by a coarse sweep about the start and a fine one about
/// its result (refined()).
/// @return disparity in the reference, in pixels; 0 where no pair sees the pixel
[[nodiscard]] Image<float> space_time_disparity(const ReferenceSurface& start, const StereoScale& stereo,
                                                std::span<const StereoView> views,
                                                const SpaceTimeOptions& options = {});

}  // namespace rva
