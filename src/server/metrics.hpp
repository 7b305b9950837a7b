// What `rva serve --metrics` lets a monitoring program read (docs/api.md).
#pragma once

#include <string>

#include "server/server_parts.hpp"

namespace rva {

/// The content type of metrics_text().
inline constexpr const char* metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

/// The metrics of this moment. They contain no names of people, aircraft or folders. May be called from any
/// thread.
[[nodiscard]] std::string metrics_text(const ServerParts& parts);

}  // namespace rva
