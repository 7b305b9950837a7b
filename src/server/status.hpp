// The status that all consoles receive regularly.
#pragma once

#include <string>

#include "server/live_pictures.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// A "status" message (docs/api.md).
/// @param consoles number of connected consoles
[[nodiscard]] std::string status_message(const ServerParts& parts, const LivePictures& pictures,
                                         std::size_t consoles);

}  // namespace rva
