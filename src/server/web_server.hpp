// Serves the console and the API over HTTP, and the live view over WebSockets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/event.hpp"
#include "core/options.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// Options of the web server.
struct ServerOptions {
  std::string address = "127.0.0.1";  ///< to listen on; "0.0.0.0" or "::" for all interfaces
  int port = 8080;                    ///< 0: any free port
  int connections = 256;
  std::string console;          ///< folder of the console's files
  std::string tls_certificate;  ///< PEM file; both or neither
  std::string tls_key;
  bool metrics = false;         ///< whether metrics_text() can be read at `/metrics`, without signing in
  double write_limit_s = 30.0;  ///< a client that takes longer to read one message is disconnected

  static void describe(auto&& self, auto&& visit) {
    visit(self.port, OptionField{"port", "", 0, 65535, "TCP port to listen at; 0 for any that is free"});
    visit(self.connections, OptionField{"connections", "", 4, 10000, "more at a time are refused"});
  }
};

/// Remote access was requested without TLS, or without an account.
class UnsafeAccessError : public OptionError {
 public:
  using OptionError::OptionError;
};

/// Remote access requires TLS and at least one account. One thread serves all connections; slow work (the
/// database, pictures, passwords) is done by two others, lists of all inspections by one more. A client that
/// sends malformed or too much data, or reads too slowly, is refused without affecting others (docs/api.md,
/// "Limits").
class WebServer {
 public:
  /// Listens at once; requests are served by run().
  /// @param log receives events, from any thread
  /// @throws OptionError when options are out of range; UnsafeAccessError when they permit unsafe access
  /// @throws Error when the server cannot listen on the address, or certificate, key or console cannot be
  /// read
  WebServer(const ServerOptions& options, const ServerParts& parts, std::function<void(const Event&)> log);
  ~WebServer();

  /// "http://127.0.0.1:8080"
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint16_t port() const;

  /// Returns after stop(). @throws Interrupted soon after a signal
  void run();
  /// May be called from any thread.
  void stop();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rva
