// The sensor of the simulated depth camera: from light to depth images.
#pragma once

#include <cstdint>
#include <vector>

#include "depth/image.hpp"
#include "sim/sensor/imager.hpp"
#include "stereo/block_matching.hpp"
#include "stereo/subpixel.hpp"

namespace rva {

/// The images of the infrared imagers, 10 bits per pixel, and the depth that was computed from them.
struct StereoFrame {
  InfraredImage left;   ///< of the left imager
  InfraredImage right;  ///< of the right imager
  DepthImage depth;     ///< in the depth unit of the options
};

/// Produces frames of one view: the same light in each, with the noise of imagers, laser and exposure.
class StereoSensor {
 public:
  /// @param view         light on both imagers
  /// @param speckle      the speckle patterns of this view, see speckle_shares()
  /// @param capture_seed seed of everything that differs between captures of one view
  StereoSensor(InfraredPair view, const StereoSensorOptions& options,
               const std::vector<SpeckleShare>& speckle, std::uint64_t capture_seed);

  /// Exposes and matches the next frame.
  [[nodiscard]] StereoFrame next_frame();

  /// Exposes the next frame like next_frame(), but leaves its depth empty: matching takes most of the time.
  [[nodiscard]] StereoFrame next_pair();

  /// Sets the exposure of the next frames.
  /// @param exposure, gain as StereoSensorOptions::exposure and gain
  void set_exposure(double exposure, double gain);

  /// The mean exposure time of a frame.
  [[nodiscard]] double exposure_us() const;

 private:
  InfraredPair view_;
  StereoSensorOptions options_;
  std::uint64_t capture_seed_;
  Speckle left_speckle_;
  Speckle right_speckle_;
  double exposure_e_ = 0.0;
  std::uint64_t frame_ = 0;
};

/// Computes disparity from a pair of infrared images, in 1/32 px; 0 where none was found.
/// @param options only its matcher and window are used
[[nodiscard]] Image<std::uint16_t> match_stereo(const InfraredImage& left, const InfraredImage& right,
                                                const StereoSensorOptions& options = {});

/// Converts disparity in 1/32 px to depth: z = f B / d, rounded to the depth unit; 0 (no depth) where there
/// is no disparity or the depth exceeds 16 bits.
[[nodiscard]] DepthImage depth_from_disparity(const Image<std::uint16_t>& disparity,
                                              const StereoSensorOptions& options);

}  // namespace rva
