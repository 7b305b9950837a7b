// One connection: requests until it ends, or becomes a WebSocket.
#pragma once

#include <functional>
#include <list>

#include "server/api.hpp"
#include "server/asio.hpp"
#include "server/complaints.hpp"
#include "server/console_files.hpp"
#include "server/live_hub.hpp"

namespace rva {

struct OpenConnection {
  bool idle = true;  ///< nothing of a request has come
  std::function<void()> close;
};

/// What connections share. For the context's thread, but for the pool.
struct Place {
  const Api& api;
  LiveHub& hub;
  const ConsoleFiles& files;
  Complaints& complaints;
  asio::thread_pool::executor_type pool;
  asio::thread_pool::executor_type lists;  ///< one thread: long lists hold up each other, and nobody else
  bool tls = false;
  bool loopback = true;
  std::list<OpenConnection> open;
};

asio::awaitable<void> serve(beast::tcp_stream stream, Place& place);
asio::awaitable<void> serve(beast::ssl_stream<beast::tcp_stream> stream, Place& place);

}  // namespace rva
