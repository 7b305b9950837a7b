// What users may state of a camera whose captures do not state it.
#pragma once

#include <array>

#include "core/error.hpp"
#include "core/options.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

inline constexpr double least_depth_unit_mm = 0.0001;  ///< the finest step of depth that may be stated
inline constexpr double most_depth_unit_mm = 1000.0;   ///< the coarsest step of depth that may be stated

/// The intrinsics for CaptureOptions, without the size of the image.
/// @param numbers fx, fy, cx, cy, px
/// @throws OptionError of the option `intrinsics` when no camera can have them
[[nodiscard]] inline Intrinsics stated_intrinsics(const std::array<double, 4>& numbers) {
  Intrinsics camera;
  camera.width = camera.height = 1;  // replaced by the size of the first image
  camera.fx = numbers[0];
  camera.fy = numbers[1];
  camera.cx = numbers[2];
  camera.cy = numbers[3];
  try {
    camera.check();
  } catch (const Error& error) {
    throw OptionError("intrinsics", error.problem(), error.remedy());
  }
  return camera;
}

}  // namespace rva
