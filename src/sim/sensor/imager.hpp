// The infrared imager: exposure, shot noise, read noise and quantisation to 10 bits.
#pragma once

#include <cstdint>

#include "sim/sensor/infrared_renderer.hpp"
#include "sim/sensor/speckle.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

/// Electrons that the longest exposure collects from a white surface in the projector's mean light at 1 m.
/// With this value, paint is well exposed at 3 m and black rubber is dim at half a metre.
inline constexpr double longest_exposure_e = 2000.0;

/// Duration of the longest exposure, seconds.
inline constexpr double longest_exposure_s = 0.033;

/// The exposure that the camera's automatic control would choose for a view, in electrons per unit of light.
/// It puts the 95th percentile of brightness at the exposure target, limited by the longest exposure.
[[nodiscard]] double automatic_exposure(const ImagerLight& view, const StereoSensorOptions& options);

/// One exposure of one imager.
/// @param exposure_e electrons per unit of light in this frame, flicker included
/// @param seed       seed of the noise of this frame and imager: the same seed gives the same noise
[[nodiscard]] InfraredImage expose(const ImagerLight& view, const Speckle& speckle, double exposure_e,
                                   const StereoSensorOptions& options, std::uint64_t seed);

}  // namespace rva
