#include "server/web_server.hpp"

#include <fmt/format.h>

#include <list>
#include <thread>

#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"
#include "server/asio.hpp"
#include "server/connection.hpp"
#include "server/health.hpp"
#include "server/metrics.hpp"
#include "server/state_events.hpp"

namespace rva {
namespace {

asio::ip::address parse_address(const std::string& text) {
  ErrorCode failure;
  const auto address = asio::ip::make_address(text, failure);
  if (failure)
    throw OptionError("address", printable(text) + " is not an IP address",
                      "give one like 127.0.0.1, or 0.0.0.0 for all interfaces");
  return address;
}

std::unique_ptr<asio::ssl::context> tls_context(const ServerOptions& options) {
  if (options.tls_certificate.empty() && options.tls_key.empty()) return nullptr;
  auto context = std::make_unique<asio::ssl::context>(asio::ssl::context::tls_server);
  context->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                       asio::ssl::context::no_tlsv1_1);
  // TLS 1.2 is limited to ciphers with forward secrecy, which keep recorded traffic secret if the key becomes
  // known later. TLS 1.3 has no others.
  if (SSL_CTX_set_cipher_list(context->native_handle(), "ECDHE+AESGCM:ECDHE+CHACHA20") != 1)
    throw Error("TLS", "the library has no cipher with forward secrecy", "install a newer OpenSSL");
  ErrorCode failure;
  context->use_certificate_chain_file(options.tls_certificate, failure);
  if (failure)
    throw Error(printable(options.tls_certificate), "contains no certificate (" + failure.message() + ")",
                "give a PEM file of the certificate and its chain");
  context->use_private_key_file(options.tls_key, asio::ssl::context::pem, failure);
  if (failure)
    throw Error(printable(options.tls_key),
                "contains no key for that certificate (" + failure.message() + ")",
                "give a PEM file of its key");
  return context;
}

void require_safe(const asio::ip::address& address, bool tls, bool accounts) {
  if (address.is_loopback()) return;
  if (!tls)
    throw UnsafeAccessError("address", "remote access requires TLS",
                            "give a certificate and its key, or use 127.0.0.1");
  if (!accounts)
    throw UnsafeAccessError("address", "remote access requires an account, and there is none",
                            "add one of an inspector, or use 127.0.0.1");
}

tcp::acceptor listen(asio::io_context& context, const asio::ip::address& address, int port) {
  const tcp::endpoint endpoint(address, static_cast<std::uint16_t>(port));
  try {
    tcp::acceptor acceptor(context);
    acceptor.open(endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(endpoint);
    acceptor.listen();
    return acceptor;
  } catch (const boost::system::system_error& error) {
    throw Error(fmt::format("{}:{}", address.to_string(), port),
                fmt::format("cannot listen on this address ({})", error.code().message()),
                "choose another port or address");
  }
}

const ServerOptions& checked(const ServerOptions& options) {
  check_options(options);
  if (options.tls_certificate.empty() != options.tls_key.empty())
    throw OptionError("tls-certificate", "and its key belong together", "give both or neither");
  return options;
}

}  // namespace

class WebServer::Implementation {
 public:
  Implementation(const ServerOptions& options, const ServerParts& parts,
                 std::function<void(const Event&)> log)
      : options_(checked(options)),
        address_(parse_address(options.address)),
        tls_(tls_context(options)),
        files_(options.console),
        log_(std::move(log)),
        complaints_([this](const std::string& line) {
          log_({EventLevel::warning, "refused", line});
        }),
        parts_(parts),
        api_(parts_, tls_ != nullptr),
        acceptor_(listen(context_, address_, options.port)),
        hub_(context_, parts_),
        shared_{api_,
                hub_,
                files_,
                complaints_,
                pool_.get_executor(),
                lists_.get_executor(),
                *parts_.traffic,
                options.metrics ? std::function([this] { return metrics_text(parts_); }) : nullptr,
                tls_ != nullptr,
                address_.is_loopback(),
                options.write_limit_s,
                {}} {
    require_safe(address_, tls_ != nullptr, parts.sessions.needed());
  }

  ~Implementation() {
    for (asio::thread_pool* const pool : {&pool_, &lists_}) {
      pool->stop();
      pool->join();
    }
  }

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

  [[nodiscard]] std::string address() const {
    const std::string host = address_.is_v6() ? "[" + address_.to_string() + "]" : address_.to_string();
    return fmt::format("{}://{}:{}", tls_ ? "https" : "http", host, port());
  }

  void run() {
    asio::co_spawn(context_, accept_all(), asio::detached);
    asio::co_spawn(context_, watch_signals(), asio::detached);
    asio::co_spawn(context_, hub_.tell_status(), asio::detached);
    asio::co_spawn(context_, log_changes(), asio::detached);
    context_.run();
    throw_if_interrupted();
  }

  void stop() {
    asio::post(context_, [this] { end(); });
  }

 private:
  // Lets every coroutine end by itself, so that none is left in the context with references to destroyed
  // objects.
  void end() {
    stopping_ = true;
    hub_.end();
    ErrorCode ignored;
    acceptor_.close(ignored);
    for (OpenConnection& connection : shared_.open) connection.close();
  }

  // Polls, since the handler of an asio::signal_set would replace the one of note_interrupts(): long work on
  // other threads would no longer notice a signal, and a second signal would no longer end the process.
  asio::awaitable<void> watch_signals() {
    asio::steady_timer timer(context_);
    while (!stopping_) {
      timer.expires_after(std::chrono::milliseconds(100));
      co_await timer.async_wait(asio::use_awaitable);
      try {
        throw_if_interrupted();
      } catch (const Interrupted&) {
        end();
      }
    }
  }

  // Checks the health on the pool, since the database may be slow and must not delay the live view.
  asio::awaitable<void> log_changes() {
    constexpr int rounds_between_checks = 10;
    asio::steady_timer timer(context_);
    for (int round = 0; !stopping_; ++round) {
      const double now_s = steady_clock().now_s();
      for (const Event& event : state_events_.of_task(parts_.inspector.task(), now_s)) log_(event);
      if (round % rounds_between_checks == 0) {
        const std::vector<HealthCheck> checks = co_await asio::co_spawn(
            pool_.get_executor(),
            [this]() -> asio::awaitable<std::vector<HealthCheck>> { co_return check_health(parts_); },
            asio::use_awaitable);
        for (const Event& event : state_events_.of_health(checks, now_s)) log_(event);
      }
      timer.expires_after(std::chrono::milliseconds(100));
      co_await timer.async_wait(asio::use_awaitable);
    }
  }

  asio::awaitable<void> accept_all() {
    for (;;) {
      ErrorCode failure;
      tcp::socket socket = co_await acceptor_.async_accept(noting(failure));
      if (stopping_) co_return;
      if (failure) {
        complaints_.add("a connection could not be accepted: " + failure.message(), steady_clock().now_s());
        asio::steady_timer pause(context_, std::chrono::milliseconds(50));
        co_await pause.async_wait(asio::use_awaitable);
        continue;
      }
      if (!make_room()) {
        complaints_.add("too many connections: some are refused", steady_clock().now_s());
        continue;  // closes it
      }
      ErrorCode ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      start(beast::tcp_stream(std::move(socket)));
    }
  }

  // Closes the oldest idle connection if there are too many. @return whether there is room, or soon will be
  bool make_room() {
    if (shared_.open.size() < static_cast<std::size_t>(options_.connections)) return true;
    complaints_.add("too many connections: idle ones are closed", steady_clock().now_s());
    for (OpenConnection& connection : shared_.open) {
      if (!connection.idle) continue;
      connection.idle = false;
      connection.close();
      return true;
    }
    return false;
  }

  void start(beast::tcp_stream stream) {
    if (tls_)
      asio::co_spawn(context_, serve(beast::ssl_stream<beast::tcp_stream>(std::move(stream), *tls_), shared_),
                     asio::detached);
    else
      asio::co_spawn(context_, serve(std::move(stream), shared_), asio::detached);
  }

  ServerOptions options_;
  asio::ip::address address_;
  std::unique_ptr<asio::ssl::context> tls_;
  ConsoleFiles files_;
  std::function<void(const Event&)> log_;
  Complaints complaints_;
  StateEvents state_events_;
  ServerParts parts_;
  Api api_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  LiveHub hub_;
  asio::thread_pool pool_{2};
  asio::thread_pool lists_{1};
  bool stopping_ = false;
  SharedState shared_;
};

WebServer::WebServer(const ServerOptions& options, const ServerParts& parts,
                     std::function<void(const Event&)> log)
    : implementation_(std::make_unique<Implementation>(options, parts, std::move(log))) {}

WebServer::~WebServer() = default;

std::string WebServer::address() const { return implementation_->address(); }
std::uint16_t WebServer::port() const { return implementation_->port(); }
void WebServer::run() { implementation_->run(); }
void WebServer::stop() { implementation_->stop(); }

}  // namespace rva
