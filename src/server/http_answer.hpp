// Converts between HTTP messages and the API.
#pragma once

#include <functional>
#include <variant>

#include "server/api.hpp"
#include "server/asio.hpp"
#include "server/console_files.hpp"

namespace rva {

/// The conditions under which an HTTP request is answered.
struct HttpCaller {
  const Api& api;
  const ConsoleFiles& files;
  bool tls = false;
  bool loopback = true;  ///< whether the server accepts connections from this computer only
  std::string from;      ///< address of the client
  /// metrics_text(), at `/metrics`; empty if nobody may read it.
  std::function<std::string()> metrics{};
};

/// May be called from any thread. Never throws.
[[nodiscard]] http::response<http::string_body> http_answer(const http::request<http::string_body>& request,
                                                            const HttpCaller& caller);

/// Converts a response and adds the security headers that every response has.
[[nodiscard]] http::response<http::string_body> http_response(const ApiResponse& answer, bool keep_alive,
                                                              bool tls);

/// The token in the session cookie; empty if there is none.
[[nodiscard]] std::string session_token(const http::request<http::string_body>& request);

/// The person who requests a WebSocket, or the refusal. The page that requests it must come from this server,
/// since browsers allow any page to request one.
[[nodiscard]] std::variant<Person, ApiResponse> who_talks(const http::request<http::string_body>& request,
                                                          const HttpCaller& caller);

}  // namespace rva
