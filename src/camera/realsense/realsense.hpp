// Intel RealSense cameras by librealsense2, if the program was built with it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "camera/camera.hpp"
#include "core/options.hpp"

namespace rva {

/// Settings for comparing depth: nothing is left to automatic control by the camera. No filter of
/// librealsense is applied.
struct RealSenseOptions {
  double rate_hz = 30.0;          ///< frames per second
  double exposure_us = 8500.0;    ///< of the infrared imagers, microseconds
  double gain = 16.0;             ///< of the infrared imagers, in the manufacturer's unit
  double laser_power_mw = 150.0;  ///< of the projector; 0 turns it off
  double depth_unit_mm = 0.1;     ///< depth of one step of a depth image
  bool infrared = true;           ///< whether frames have the images of the infrared imagers, too

  static void describe(auto&& self, auto&& visit) {
    visit(self.rate_hz, OptionField{"rate", "hz", 1, 90, "frames a second of a RealSense"});
    visit(self.exposure_us, OptionField{"exposure", "us", 1, 165000,
                                        "of a RealSense's infrared imagers, which see depth; not automatic"});
    visit(self.gain, OptionField{"gain", "", 16, 248, "of a RealSense's infrared imagers"});
    visit(self.laser_power_mw,
          OptionField{"laser-power", "mw", 0, 360, "of a RealSense's projector; 0 turns it off"});
    visit(self.depth_unit_mm,
          OptionField{"depth-unit", "mm", 0.01, 10,
                      "of a RealSense; 65535 of them are the farthest that a depth image can represent"});
    visit(self.infrared,
          OptionField{"infrared", "", 0, 1, "1: the images of a RealSense's infrared imagers, too"});
  }
};

/// A connected camera. Texts are empty where the camera does not state them.
struct FoundCamera {
  std::string model;     ///< name of the product, as in CameraInfo::model
  std::string serial;    ///< serial number
  std::string firmware;  ///< version of the firmware
  std::string usb;       ///< type of the port: "3.2"; "2.1" is too slow for all frames
};

/// Whether the program was built with librealsense2.
[[nodiscard]] bool has_realsense();

/// The cameras that can be opened.
/// @throws Error when none can be opened although one is plugged in, or the program was built
///         without librealsense2
[[nodiscard]] std::vector<FoundCamera> realsense_cameras();

/// Opens a camera: depth of 848x480 pixels, and colour and infrared of the same size where available.
/// Settings are applied, read back and stated in info(); info().notes states settings that differ from the
/// options, and a port that is too slow. If the camera is disconnected, calls throw Error, and the first call
/// after it has been connected again reopens it; frames missed meanwhile leave a gap in the numbers.
///
/// @param serial empty for the only connected camera
/// @throws UsageError when an option is out of range
/// @throws Error      as realsense_cameras(); when there is no such camera, or several and `serial` is empty;
///                    when another program uses it
[[nodiscard]] std::unique_ptr<Camera> open_realsense(const std::string& serial,
                                                     const RealSenseOptions& options = {});

}  // namespace rva
