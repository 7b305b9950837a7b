// Temporal noise and drift of the depth of a still scene (thesis chapters 3.2.3 and 4.2.3).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "capture/capture.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"

namespace rva {

/// Options of the measurement of a camera's noise.
struct NoiseOptions {
  int frames = 0;         ///< number of frames to use, from the first; 0 for all
  int welch_frames = 10;  ///< frames at either end that Welch's test compares; fewer of short captures
  double alpha = 0.01;    ///< p-value of Welch's test below which a pixel drifts
  double bin_m = 0.25;    ///< width of the ranges of distance of the report

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "frames to use, from the first; 0 for all"});
    visit(self.welch_frames,
          OptionField{"welch-frames", "", 2, 10000,
                      "frames at either end that Welch's test compares; fewer where the capture is short"});
    visit(self.alpha,
          OptionField{"alpha", "", 1e-12, 0.5, "Welch's test marks pixels with a p-value below this"});
    visit(self.bin_m, OptionField{"bin", "m", 0.01, 10, "width of the distance classes of the report"});
  }
};

/// Noise of the pixels in one range of distances.
struct NoiseBin {
  double from_m = 0.0;                    ///< least distance, included
  double to_m = 0.0;                      ///< greatest distance, not included
  std::size_t pixels = 0;                 ///< number of pixels with two or more measurements
  double median_std_mm = 0.0;             ///< median of the standard deviation over time, along z
  double p95_std_mm = 0.0;                ///< 95th percentile of the same
  std::optional<double> subpixel_rms_px;  ///< disparity noise, where the baseline is known
};

/// The noise of a camera, summarised over its pixels.
struct NoiseReport {
  std::size_t frames = 0;           ///< number of frames that were measured
  double fill_rate = 0.0;           ///< share of all pixels of all frames that have a measurement
  NoiseBin overall;                 ///< over all pixels with two or more measurements
  std::vector<NoiseBin> bins;       ///< ranges of distance that contain pixels, near to far
  std::size_t welch_frames = 0;     ///< number of frames at either end that Welch's test compares
  double alpha = 0.0;               ///< level of significance of that test
  std::size_t welch_tested_px = 0;  ///< number of tested pixels
  /// Share of the tested pixels with p < alpha; about alpha if nothing drifted.
  double welch_rejected = 0.0;
};

/// The noise of a camera, for each pixel and summarised.
struct Noise {
  Image<float> std_mm;   ///< population standard deviation along z; NaN where fewer than two measurements
  Image<float> welch_p;  ///< p-value; NaN where untested (fewer than two measurements at either end)
  NoiseReport report;    ///< summary, as `rva noise` prints it
};

/// Measures the noise and the drift of each pixel over the frames of a capture of a still scene.
/// @throws Error when there are fewer than four frames (Welch's test needs two at either end), all are one
///         image (capture/frozen.hpp), or one cannot be read; UsageError when an option is out of range;
///         Interrupted
[[nodiscard]] Noise measure_noise(const Capture& capture, const NoiseOptions& options,
                                  const Progress& progress);

/// Two-sided p-value of Welch's unequal-variances t-test between the two sets' means of pixel i, with the
/// Welch-Satterthwaite degrees of freedom (Welch 1947); NaN where either has fewer than two measurements.
/// Two constant sets give 1 when equal, 0 otherwise.
[[nodiscard]] double welch_p_value(const DepthStatistics& a, const DepthStatistics& b, std::size_t i);

}  // namespace rva
