// Conversions between units. A number carries its unit in its name (docs/design.md).
#pragma once

#include <numbers>

namespace rva {

inline constexpr double mm_per_m = 1000.0;                       ///< millimetres in a metre
inline constexpr double m_per_mm = 0.001;                        ///< metres in a millimetre
inline constexpr double us_per_s = 1e6;                          ///< microseconds in a second
inline constexpr double rad_per_deg = std::numbers::pi / 180.0;  ///< radians in a degree

/// Degrees as radians.
[[nodiscard]] constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }
/// Radians as degrees.
[[nodiscard]] constexpr double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

}  // namespace rva
