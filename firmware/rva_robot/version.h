// The versions that the robot reports.
#ifndef RVA_ROBOT_VERSION_H
#define RVA_ROBOT_VERSION_H

#include <stdint.h>

namespace rva_robot {

/// The version of the protocol in docs/protocol.md.
constexpr uint8_t protocol_version = 1;
constexpr const char* firmware_version = "1.1.0";

}  // namespace rva_robot

#endif
