// Checks of the computer: rights, USB, disk.
#pragma once

#include <filesystem>
#include <vector>

#include "doctor/checkup.hpp"
#include "doctor/device_nodes.hpp"

namespace rva {

/// What is going to be used.
struct ComputerNeeds {
  bool realsense = false;             ///< a RealSense camera
  std::filesystem::path serial_port;  ///< of the robot; empty if it has none
  std::filesystem::path data;         ///< folder in which captures will be kept; it need not exist
  double least_free_gb = 2.0;         ///< DoctorOptions::least_free_gb
};

/// Where Linux describes its devices: other folders in tests.
struct ComputerFolders {
  std::filesystem::path sys = "/sys";  ///< sysfs
  std::filesystem::path dev = "/dev";  ///< nodes of devices
  /// Rules of udev; those of packages and of the administrator.
  std::vector<std::filesystem::path> udev_rules{"/etc/udev/rules.d", "/usr/lib/udev/rules.d",
                                                "/lib/udev/rules.d"};
  MayOpen may_open = may_read_and_write;  ///< whether a node may be opened
};

/// Checks "udev-rules", "camera-rights", "usb", "robot-rights", "data-folder", "disk", in this order.
[[nodiscard]] CheckedItems examine_computer(const ComputerNeeds& needs, const ComputerFolders& folders = {});

}  // namespace rva
