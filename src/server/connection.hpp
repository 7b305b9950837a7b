// Serves one connection: requests until it ends or becomes a WebSocket.
#pragma once

#include <functional>
#include <list>

#include "server/api.hpp"
#include "server/asio.hpp"
#include "server/complaints.hpp"
#include "server/console_files.hpp"
#include "server/live_hub.hpp"

namespace rva {

/// An open connection and how to close it.
struct OpenConnection {
  bool idle = true;  ///< no complete request has arrived since the last response
  std::function<void()> close;
};

/// The state that all connections share. Only `api` and `files` are used on the pools' threads, too; all else
/// belongs to the context's thread.
struct SharedState {
  const Api& api;
  LiveHub& hub;
  const ConsoleFiles& files;
  Complaints& complaints;
  asio::thread_pool::executor_type pool;
  asio::thread_pool::executor_type lists;  ///< one thread, so that long lists delay only each other
  Traffic& traffic;
  std::function<std::string()> metrics;  ///< HttpCaller::metrics
  bool tls = false;
  bool loopback = true;
  double write_limit_s = 30.0;  ///< for sending one message or response
  std::list<OpenConnection> open;
};

asio::awaitable<void> serve(beast::tcp_stream stream, SharedState& shared);
asio::awaitable<void> serve(beast::ssl_stream<beast::tcp_stream> stream, SharedState& shared);

}  // namespace rva
