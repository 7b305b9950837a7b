// Conversions between units. A number carries its unit in its name (docs/design.md).
#pragma once

#include <numbers>

namespace rva {

inline constexpr double mm_per_m = 1000.0;
inline constexpr double m_per_mm = 0.001;
inline constexpr double rad_per_deg = std::numbers::pi / 180.0;

[[nodiscard]] constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }
[[nodiscard]] constexpr double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

}  // namespace rva
