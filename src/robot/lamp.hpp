// The lamp around the camera.
#pragma once

#include <optional>

namespace rva {

/// The lamp as the robot reports it.
struct LampState {
  int percent = 0;                  ///< brightness, 0 (off) to 100
  std::optional<double> celsius{};  ///< temperature of its frame; empty for a simulated one
  bool too_hot = false;             ///< it was switched off, and stays off until it has cooled down
  bool operator==(const LampState&) const = default;
};

/// @throws UsageError when a brightness is not within 0 to 100
void check_lamp_percent(int percent);

}  // namespace rva
