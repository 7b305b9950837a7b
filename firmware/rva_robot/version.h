// What the robot says it is.
#ifndef RVA_ROBOT_VERSION_H
#define RVA_ROBOT_VERSION_H

#include <stdint.h>

namespace rva_robot {

/// docs/protocol.md
constexpr uint8_t protocol_version = 1;
constexpr const char* firmware_version = "1.0.0";

}  // namespace rva_robot

#endif
