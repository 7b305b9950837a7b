// Noise model: how much disparity differs between two captures where nothing changed, learnt from the
// captures themselves.
#pragma once

#include <optional>

#include "geometry/stereo_scale.hpp"
#include "views/disparity_change.hpp"

namespace rva {

/// The noise model of a comparison, for each pixel and summarised.
struct NoiseByClass {
  Image<float> deviation_px;  ///< of the change of an unchanged pixel about the drift; 0 where not judged
  /// Averaging over the frames reduces the deviation of a single frame as averaging over this many
  /// independent frames would. Empty if deviation over time explains nothing, as with one frame per side.
  std::optional<double> effective_frames;
  double fixed_px = 0.0;  ///< part of the noise that does not decrease with the number of frames
};

/// Estimates the noise of each pixel from classes of similar pixels: seven levels of deviation over time,
/// each for reliable and unreliable pixels, 14 in all. The deviation of a class is estimated from the median
/// absolute change about the drift, as for a normal distribution, because changed pixels are a minority and
/// must not count as noise. Classes with few pixels are drawn towards the whole image. The rounding of depth
/// is the lower limit of the deviation. Added are the uncertainty of the drift and, if a pixel varies more
/// over time than its class, its excess variance divided by four: such pixels stay at one level for many
/// frames, so that as few as four frames may be independent.
///
/// Effective frames and the fixed part follow from a straight line through the classes: variance = fixed^2 +
/// deviation over time^2 / frames.
/// @param unreliable                   as returned by unreliable_pixels()
/// @param drift_px, drift_variance_px2 drift and its variance at every pixel
[[nodiscard]] NoiseByClass noise_by_class(const DisparityChange& change, const Mask& unreliable,
                                          const Image<float>& drift_px,
                                          const Image<float>& drift_variance_px2, const StereoScale& stereo);

}  // namespace rva
