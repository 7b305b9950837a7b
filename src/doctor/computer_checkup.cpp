#include "doctor/computer_checkup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "core/folder_space.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

// The first file of rules whose name contains this text.
fs::path rules_named(const std::vector<fs::path>& folders, std::string_view text) {
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    for (fs::directory_iterator file(folder, ignored), end; !ignored && file != end;
         file.increment(ignored)) {
      const std::string name = file->path().filename().string();
      if (name.ends_with(".rules") && name.find(text) != std::string::npos) return file->path();
    }
  }
  return {};
}

CheckedItem udev_item(const ComputerNeeds& needs, const ComputerFolders& folders) {
  constexpr const char* name = "udev-rules";
  if (!needs.realsense && needs.serial_port.empty()) return not_tried(name, "no device is used");
  if (const fs::path own = rules_named(folders.udev_rules, "rva-server"); !own.empty())
    return passed(name, printable(own));
  const fs::path others = rules_named(folders.udev_rules, "realsense");
  if (!others.empty() && needs.serial_port.empty()) return passed(name, printable(others));
  return {
      name,
      CheckState::warning,
      others.empty() ? "no rules let others than root open the devices"
                     : printable(others) + " is for cameras alone",
      "install rva-server, or copy debian/rva-server.udev to /etc/udev/rules.d/60-rva-server.rules, and run: "
      "sudo udevadm control --reload",
      {}};
}

CheckedItem camera_rights_item(const std::vector<PluggedIn>& cameras, const ComputerFolders& folders) {
  constexpr const char* name = "camera-rights";
  std::size_t nodes = 0;
  for (const PluggedIn& camera : cameras) {
    for (const fs::path& node : nodes_of(camera, folders.dev)) {
      ++nodes;
      if (!folders.may_open(node))
        return {name,
                CheckState::failed,
                printable(node) + " of the camera may not be opened",
                advice_to_open(node),
                {}};
    }
  }
  return passed(name, fmt::format("{} nodes of the camera may be opened", nodes));
}

CheckedItem usb_item(const std::vector<PluggedIn>& cameras) {
  constexpr const char* name = "usb";
  constexpr double usb_3_mbps = 5000.0;
  const PluggedIn& slowest = *std::ranges::min_element(cameras, {}, &PluggedIn::speed_mbps);
  CheckedItem item =
      passed(name, fmt::format("{}: {:.0f} Mbit/s", printable(slowest.product), slowest.speed_mbps));
  item.values = {{"speed_mbit_s", slowest.speed_mbps}};
  if (slowest.speed_mbps >= usb_3_mbps) return item;
  item.state = CheckState::warning;
  item.result += ", which is USB 2: too slow for all frames";
  item.advice = "use a USB 3 port and a USB 3 cable, push the plug in completely, and leave out hubs";
  return item;
}

CheckedItems camera_items(const ComputerNeeds& needs, const ComputerFolders& folders) {
  const std::vector<std::string> names{"camera-rights", "usb"};
  if (!needs.realsense) return none_tried(names, "the camera is no device");
  const std::vector<PluggedIn> cameras = plugged_in_realsense(folders.sys / "bus/usb/devices");
  if (cameras.empty()) return none_tried(names, "no RealSense is plugged in");
  return {camera_rights_item(cameras, folders), usb_item(cameras)};
}

// The serial ports that boards have, as text.
std::string ports_in(const fs::path& dev) {
  std::vector<std::string> ports;
  std::error_code ignored;
  for (fs::directory_iterator node(dev, ignored), end; !ignored && node != end; node.increment(ignored)) {
    const std::string name = node->path().filename().string();
    if (name.starts_with("ttyACM") || name.starts_with("ttyUSB")) ports.push_back(printable(node->path()));
  }
  std::ranges::sort(ports);
  std::string text;
  for (const std::string& port : ports) text += (text.empty() ? "" : ", ") + port;
  return text;
}

CheckedItem robot_rights_item(const ComputerNeeds& needs, const ComputerFolders& folders) {
  constexpr const char* name = "robot-rights";
  const fs::path& port = needs.serial_port;
  if (port.empty()) return not_tried(name, "no robot on a serial port was named");
  if (!fs::exists(port)) {
    const std::string others = ports_in(folders.dev);
    return {name,
            CheckState::failed,
            printable(port) + " does not exist",
            others.empty() ? "plug the robot's board in; no board has a serial port at present"
                           : "plug the robot's board in, or name one of these: " + others,
            {}};
  }
  if (!folders.may_open(port))
    return {name, CheckState::failed, printable(port) + " may not be opened", advice_to_open(port), {}};
  return passed(name, printable(port) + " may be opened");
}

// The folder itself, or the one in which it would be made.
fs::path existing(const fs::path& folder) {
  fs::path here = fs::absolute(folder).lexically_normal();
  while (!fs::exists(here) && here.has_relative_path()) here = here.parent_path();
  return here;
}

CheckedItem data_item(const fs::path& data) {
  constexpr const char* name = "data-folder";
  try {
    require_writable(existing(data));
    return passed(name, printable(data) + (fs::exists(data) ? " can be written" : " can be made"));
  } catch (const Error& error) {
    return failed(name, error);
  }
}

CheckedItem disk_item(const fs::path& data, double least_free_gb) {
  constexpr const char* name = "disk";
  constexpr double bytes_per_gb = 1e9;
  constexpr double comfortable = 10.0;
  try {
    const double free_gb = static_cast<double>(space_of(existing(data)).free_bytes) / bytes_per_gb;
    CheckedItem item = passed(name, fmt::format("{:.1f} GB are free", free_gb));
    item.values = {{"free_gb", free_gb}, {"least_free_gb", least_free_gb}};
    if (free_gb >= comfortable * least_free_gb) return item;
    item.state = free_gb < least_free_gb ? CheckState::failed : CheckState::warning;
    item.result += free_gb < least_free_gb ? fmt::format(", and {:.1f} GB are needed", least_free_gb)
                                           : ", which is enough for a few inspections";
    item.advice = "delete what nobody needs, or choose a folder on another disk with --data";
    return item;
  } catch (const Error& error) {
    return failed(name, error);
  }
}

}  // namespace

CheckedItems examine_computer(const ComputerNeeds& needs, const ComputerFolders& folders) {
  CheckedItems items{udev_item(needs, folders)};
  for (CheckedItem& item : camera_items(needs, folders)) items.push_back(std::move(item));
  items.push_back(robot_rights_item(needs, folders));
  items.push_back(data_item(needs.data));
  items.push_back(disk_item(needs.data, needs.least_free_gb));
  return items;
}

}  // namespace rva
