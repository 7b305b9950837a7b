// The files by which Linux lets programs open a camera, and whether this program may open them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "camera/realsense/plugged_in.hpp"

namespace rva {

/// Whether a device may be read and written by this program.
using MayOpen = std::function<bool(const std::filesystem::path& node)>;

/// Asks the system, which takes groups and access lists into account.
[[nodiscard]] bool may_read_and_write(const std::filesystem::path& node);

/// The nodes of a camera: that of the USB device, and those of its video streams.
/// @param dev the folder of all nodes, such as /dev
/// @return only nodes that exist
[[nodiscard]] std::vector<std::filesystem::path> nodes_of(const PluggedIn& camera,
                                                          const std::filesystem::path& dev);

/// What the user can do about a node that may not be opened: join the group that has it, if there is one.
[[nodiscard]] std::string advice_to_open(const std::filesystem::path& node);

}  // namespace rva
