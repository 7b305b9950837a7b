// Captures of a camera that was frozen: it delivered one depth image again and again.
#pragma once

#include <cstddef>
#include <string>

#include "capture/capture.hpp"
#include "core/error.hpp"

namespace rva {

/// Whether the first `frames` depth frames, two or more, are one image. A depth camera has noise, so that no
/// two of its images are equal; equal ones show how little a frozen camera varies, and not how well it
/// measures. Images without any measurement do not count: they have another reason.
///
/// Reads frames until one differs, which usually is the second.
/// @param frames at most capture.depth_frames()
/// @throws Error as Capture::depth()
[[nodiscard]] bool is_frozen(const Capture& capture, std::size_t frames);

/// Whether the frames that two captures have in common, of the first ones that are used, are the same images,
/// as those of a copy are. False for images without any measurement.
/// @param a_frames, b_frames at least 1 and at most depth_frames()
/// @throws Error as Capture::depth()
[[nodiscard]] bool are_copies(const Capture& a, std::size_t a_frames, const Capture& b, std::size_t b_frames);

/// The refusal of a frozen camera. @param source the capture or the camera
[[nodiscard]] Error frozen_camera(std::string source);

}  // namespace rva
