// Boost.Asio and Beast with coroutines, and short names for them. Only for source files of src/server.
#pragma once

// Boost 1.74 detects the coroutines of g++ only, but clang-tidy parses with clang.
#if defined(__clang__)
#define BOOST_ASIO_HAS_CO_AWAIT 1
#define BOOST_ASIO_HAS_STD_COROUTINE 1
#endif

#include <utility>  // missing in Boost 1.74's awaitable.hpp

// After <utility>.
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>

namespace rva {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
/// TCP in Boost.Asio.
using tcp = asio::ip::tcp;
/// An error code of Boost.Asio.
using ErrorCode = boost::system::error_code;

/// Completion token with which co_await stores an error in `failure` instead of throwing it.
inline auto noting(ErrorCode& failure) { return asio::redirect_error(asio::use_awaitable, failure); }

}  // namespace rva
