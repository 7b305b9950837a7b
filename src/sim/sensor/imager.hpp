// From light to numbers: exposure, shot noise, read noise, 10 bits.
#pragma once

#include <cstdint>

#include "sim/sensor/infrared_renderer.hpp"
#include "sim/sensor/speckle.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

/// What the longest exposure gathers from a white surface in the projector's mean light at 1 m: paint is seen
/// well at 3 m, black rubber is dim at half a metre.
inline constexpr double longest_exposure_e = 2000.0;
inline constexpr double longest_exposure_s = 0.033;

/// Electrons per unit of light that the camera's own control would choose for a view: its brighter parts
/// (95 % of pixels are darker) at the exposure target, as far as the longest exposure reaches.
[[nodiscard]] double automatic_exposure(const ImagerLight& view, const StereoSensorOptions& options);

/// One exposure of one imager.
/// @param exposure_e electrons per unit of light in this frame, flicker included
/// @param seed       of this frame and imager: the same seed gives the same noise
[[nodiscard]] InfraredImage expose(const ImagerLight& view, const Speckle& speckle, double exposure_e,
                                   const StereoSensorOptions& options, std::uint64_t seed);

}  // namespace rva
