// Asks a time stamp server over HTTP (RFC 3161, section 3.4).
#pragma once

#include <functional>
#include <string>

#include "audit/package_writer.hpp"
#include "core/error.hpp"

namespace rva {

/// Time stamps of a server, which gets ten seconds for each. A time stamp proves itself by its signature, so
/// that plain HTTP is enough.
/// @param url        "http://HOST[:PORT][/PATH]"; empty for no time stamps
/// @param on_failure is called, beside the exception, when the server gives no time stamp
/// @throws OptionError for `timestamp-server` when it is another URL
[[nodiscard]] TimeStamping time_stamping(const std::string& url,
                                         std::function<void(const Error& failure)> on_failure);

}  // namespace rva
