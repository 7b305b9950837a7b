// The console and the API over HTTP, the live view over WebSockets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/options.hpp"
#include "server/server_parts.hpp"

namespace rva {

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< to listen at; "0.0.0.0" or "::" for all
  int port = 8080;                    ///< 0: any that is free
  int connections = 256;
  std::string console;          ///< folder of the console's files
  std::string tls_certificate;  ///< PEM file; both or neither
  std::string tls_key;

  static void describe(auto&& self, auto&& visit) {
    visit(self.port, OptionField{"port", "", 0, 65535, "TCP port to listen at; 0 for any that is free"});
    visit(self.connections, OptionField{"connections", "", 4, 10000, "more at a time are refused"});
  }
};

/// Beyond this computer there must be TLS and at least one account. One thread serves all; what takes time
/// (the database, pictures, passwords) is done by two others, lists of all inspections by one more. A visitor
/// who sends what is malformed or too much, or reads too slowly, is refused without a say in what others get
/// (docs/api.md, "Limits").
class WebServer {
 public:
  /// Listens from now on, and serves from run() on.
  /// @param log takes lines for a person, from any thread
  /// @throws UsageError when options are out of range, or not safe for others than this computer
  /// @throws Error when the address cannot be listened at, or certificate, key or console cannot be read
  WebServer(const ServerOptions& options, const ServerParts& parts,
            std::function<void(const std::string&)> log);
  ~WebServer();

  /// "http://127.0.0.1:8080"
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint16_t port() const;

  /// Returns after stop(), or soon after a signal.
  void run();
  /// From any thread.
  void stop();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rva
