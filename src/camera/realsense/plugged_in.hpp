// Finds RealSense cameras by Linux' list of USB devices, including those that cannot be opened.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rva {

/// A RealSense device as the operating system lists it.
struct PluggedIn {
  std::string product;           ///< "Intel(R) RealSense(TM) Depth Camera 435"
  double speed_mbps = 0.0;       ///< speed of the USB link, Mbit/s: 480 for USB 2, 5000 or more for USB 3
  std::filesystem::path folder;  ///< in which Linux describes the device
};

/// The RealSense cameras that are plugged in, whether they can be opened or not.
/// @param devices the folder in which Linux lists USB devices
[[nodiscard]] std::vector<PluggedIn> plugged_in_realsense(
    const std::filesystem::path& devices = "/sys/bus/usb/devices");

}  // namespace rva
