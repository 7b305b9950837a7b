// Intel RealSense cameras through librealsense2, where the program was built with it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "camera/camera.hpp"
#include "core/options.hpp"

namespace rva {

/// The settings of a careful user: nothing that the camera changes by itself while depth is compared. No
/// filter of librealsense is applied.
struct RealSenseOptions {
  double rate_hz = 30.0;
  double exposure_us = 8500.0;
  double gain = 16.0;
  double laser_power_mw = 150.0;
  double depth_unit_mm = 0.1;
  bool infrared = true;

  static void describe(auto&& self, auto&& visit) {
    visit(self.rate_hz, OptionField{"rate", "hz", 1, 90, "frames a second of a RealSense"});
    visit(self.exposure_us, OptionField{"exposure", "us", 1, 165000,
                                        "of a RealSense's infrared imagers, which see depth; not automatic"});
    visit(self.gain, OptionField{"gain", "", 16, 248, "of a RealSense's infrared imagers"});
    visit(self.laser_power_mw,
          OptionField{"laser-power", "mw", 0, 360, "of a RealSense's projector; 0 turns it off"});
    visit(self.depth_unit_mm, OptionField{"depth-unit", "mm", 0.01, 10,
                                          "of a RealSense; 65535 of them are the farthest it can say"});
    visit(self.infrared,
          OptionField{"infrared", "", 0, 1, "1: the images of a RealSense's infrared imagers, too"});
  }
};

/// A camera that is there. Texts are empty where the camera does not say.
struct FoundCamera {
  std::string model;
  std::string serial;
  std::string firmware;
  std::string usb;  ///< "3.2"; "2.1" is too slow for all frames
};

/// Whether the program was built with librealsense2.
[[nodiscard]] bool has_realsense();

/// Those that can be opened.
/// @throws Error where one is plugged in that this user may not open, or the program was built without
///         librealsense2
[[nodiscard]] std::vector<FoundCamera> realsense_cameras();

/// Depth of 848x480 pixels, colour and infrared of the same size. Settings are applied, read back
/// and stated in info(); what the camera took otherwise than asked is in info().notes, and so is a port that
/// is too slow. A camera that goes away fails a call with an Error, and the first call after it is back opens
/// it anew; frames missed meanwhile show as a gap in the numbers.
///
/// @param serial empty: the only one that there is
/// @throws UsageError when an option is out of range
/// @throws Error      as realsense_cameras(); when there is no such camera, or several and none is named;
///                    when another program uses it
[[nodiscard]] std::unique_ptr<Camera> open_realsense(const std::string& serial,
                                                     const RealSenseOptions& options = {});

}  // namespace rva
