// Between HTTP messages and the API.
#pragma once

#include <variant>

#include "server/api.hpp"
#include "server/asio.hpp"
#include "server/console_files.hpp"

namespace rva {

struct HttpCaller {
  const Api& api;
  const ConsoleFiles& files;
  bool tls = false;
  bool loopback = true;  ///< listens to this computer only
  std::string from;      ///< the address that asks
};

/// From any thread. Never throws.
[[nodiscard]] http::response<http::string_body> http_answer(const http::request<http::string_body>& request,
                                                            const HttpCaller& caller);

/// With what every answer says for a browser's safety.
[[nodiscard]] http::response<http::string_body> http_response(const ApiResponse& answer, bool keep_alive,
                                                              bool tls);

/// What says who somebody is, in their cookie; empty where they have none.
[[nodiscard]] std::string session_token(const http::request<http::string_body>& request);

/// Whoever wants a WebSocket, or why not. Its page must come from here: browsers let any page ask.
[[nodiscard]] std::variant<Person, ApiResponse> who_talks(const http::request<http::string_body>& request,
                                                          const HttpCaller& caller);

}  // namespace rva
