// Limits of angle and speed, in hundredths of a degree; angles are those that the servos measure.
#ifndef RVA_ROBOT_LIMITS_H
#define RVA_ROBOT_LIMITS_H

#include <stdint.h>

namespace rva_robot {

enum Axis : uint8_t { pan = 0, tilt = 1, axes = 2 };

struct AxisLimits {
  int16_t min_cdeg;
  int16_t max_cdeg;
};

/// Both ends are allowed. The upper limit of tilt is small because of the camera's cable.
constexpr AxisLimits limits[axes] = {{-9000, 9000}, {-9000, 900}};

constexpr int16_t slowest_cdeg_s = 100;
constexpr int16_t fastest_cdeg_s = 9000;

inline bool within_limits(uint8_t axis, int16_t cdeg) {
  return cdeg >= limits[axis].min_cdeg && cdeg <= limits[axis].max_cdeg;
}

}  // namespace rva_robot

#endif
