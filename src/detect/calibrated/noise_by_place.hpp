// How much disparity differs between two captures where nothing changed: learnt from the captures themselves.
#pragma once

#include <optional>

#include "detect/calibrated/disparity_change.hpp"

namespace rva {

struct NoiseByPlace {
  Image<float> deviation_px;  ///< of an unchanged pixel, about the drift; 0 where not judged
  /// What a single frame's deviation over time shrinks to in the mean is that of so many independent frames;
  /// empty where deviation over time explains nothing, as with one frame a side.
  std::optional<double> effective_frames;
  double fixed_px = 0.0;  ///< what no number of frames would average away
};

/// Pixels that vary alike over time, in sure or in unsure places, are of one class, 14 in all. The
/// deviation of a class is the median size of its change about the drift, as that of a normal distribution:
/// what changed is in the minority, and cannot pass for noise. Classes of few pixels lean on the whole
/// image. Rounding of depth sets the least deviation. Added are the uncertainty of the drift and, where a
/// pixel varies more over time than its class, what the excess would leave in a mean of four frames: such
/// pixels rest on one level for many frames.
///
/// Effective frames and fixed part: the line variance = fixed^2 + deviation over time^2 / frames through the
/// classes.
/// @param unsure               as of unsure_places()
/// @param drift_px, drift_variance_px2 of every pixel
/// @param disparity_by_depth           as for disparity_change()
[[nodiscard]] NoiseByPlace noise_by_place(const DisparityChange& change, const Mask& unsure,
                                          const Image<float>& drift_px,
                                          const Image<float>& drift_variance_px2, double disparity_by_depth);

}  // namespace rva
