// Refuses captures that cannot be what they are given for: copies, and those of a frozen camera.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "capture/capture.hpp"

namespace rva {

/// Checks that no capture is given twice, by the files that the paths lead to. A comparison of a capture with
/// itself finds nothing, which must not be taken for an inspection.
/// @throws Error when two paths lead to the same file or folder
void require_distinct(std::span<const std::filesystem::path> initial,
                      std::span<const std::filesystem::path> final);

/// Checks that no capture, of either side, is a copy of another one, and that none is of a frozen camera: its
/// noise would be estimated as nothing at all. Reads the first two frames of each, usually.
/// @param frames the frames of each capture that are used, from the first; 0 for all. A single one does not
///               show whether the camera was frozen.
/// @throws Error when one is, or when a frame cannot be read
void require_genuine(const Captures& initial, const Captures& final, std::size_t frames);

}  // namespace rva
