#include "server/connection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/clock.hpp"
#include "server/http_answer.hpp"
#include "server/private_paths.hpp"

namespace rva {
namespace {

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

constexpr std::chrono::seconds first_request_limit{10};
constexpr std::chrono::seconds next_request_limit{30};
constexpr std::size_t most_header_bytes = 8192;
constexpr std::size_t most_body_bytes = 65536;

std::chrono::milliseconds milliseconds_of(double time_s) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * time_s));
}

double now_s() { return steady_clock().now_s(); }

/// Keeps a connection in the list of open ones during its own lifetime.
class Registered {
 public:
  Registered(SharedState& shared, std::function<void()> close)
      : shared_(shared), entry_(shared.open.insert(shared.open.end(), {true, std::move(close)})) {}
  ~Registered() { shared_.open.erase(entry_); }
  Registered(const Registered&) = delete;
  Registered& operator=(const Registered&) = delete;
  void set_idle(bool idle) { entry_->idle = idle; }

 private:
  SharedState& shared_;
  std::list<OpenConnection>::iterator entry_;
};

// Runs on the pool, since the database may be slow and must not delay the live view.
asio::awaitable<std::optional<Person>> person_now(const std::string& token, SharedState& shared) {
  co_return co_await asio::co_spawn(
      shared.pool,
      [&]() -> asio::awaitable<std::optional<Person>> {
        try {
          co_return shared.api.person(token);
        } catch (const Error&) {
          co_return std::nullopt;  // without the records, nobody can be identified
        }
      },
      asio::use_awaitable);
}

/// The coroutines beside the reader that use a connection's socket. The socket must stay until they have
/// ended.
class SocketUsers {
 public:
  explicit SocketUsers(asio::any_io_executor executor)
      : executor_(std::move(executor)), ended_(executor_, asio::steady_timer::time_point::max()) {}
  SocketUsers(const SocketUsers&) = delete;
  SocketUsers& operator=(const SocketUsers&) = delete;

  void start(asio::awaitable<void> user) {
    ++running_;
    asio::co_spawn(executor_, std::move(user), [this](const std::exception_ptr& /*failure*/) {
      if (--running_ == 0) ended_.cancel();
    });
  }

  asio::awaitable<void> wait() {
    ErrorCode cancelled;
    while (running_ > 0) co_await ended_.async_wait(noting(cancelled));
  }

 private:
  asio::any_io_executor executor_;
  asio::steady_timer ended_;  ///< never expires; cancelled when the last user has ended
  int running_ = 0;
};

template <typename Socket>
asio::awaitable<void> write_all(Socket& socket, std::shared_ptr<LiveHub::Member> member) {
  ErrorCode failure;
  while (!member->ended && !failure) {
    const std::optional<Message> message = member->conversation.next(now_s());
    if (!message) {
      ErrorCode woken;
      member->alarm.expires_after(std::chrono::seconds(1));
      co_await member->alarm.async_wait(noting(woken));
      continue;
    }
    socket.binary(message->binary);
    member->writing_since_s = now_s();
    co_await socket.async_write(asio::buffer(message->bytes), noting(failure));
    member->writing_since_s.reset();
  }
  if (failure) beast::get_lowest_layer(socket).close();
}

template <typename Socket>
asio::awaitable<std::string> read_all(Socket& socket, LiveHub::Member& member, LiveHub& hub) {
  for (;;) {
    beast::flat_buffer buffer;
    ErrorCode failure;
    co_await socket.async_read(buffer, noting(failure));
    if (failure == websocket::error::message_too_big || failure == websocket::error::buffer_overflow)
      co_return "a WebSocket message was too large";
    if (failure) co_return "";
    if (!socket.got_text()) co_return "a WebSocket message was not text";
    try {
      const auto bytes = buffer.cdata();
      member.conversation.hear({static_cast<const char*>(bytes.data()), bytes.size()}, now_s());
      hub.pass_on_pointing(member);
      member.wake();
    } catch (const std::exception& error) {  // a violation of the protocol, or an internal error
      co_return std::string(error.what());
    }
  }
}

// Closes a connection whose client has not read a message within the limit. The stream's own timeout cannot
// be used: set for a write while no read is pending, it would end the next read, and with it the connection
// of a client that has nothing to send.
template <typename Socket>
asio::awaitable<void> watch_writing(Socket& socket, std::shared_ptr<LiveHub::Member> member, double limit_s) {
  while (!member->ended) {
    ErrorCode woken;
    member->next_look.expires_after(std::chrono::milliseconds(200));
    co_await member->next_look.async_wait(noting(woken));
    if (member->writing_since_s && now_s() - *member->writing_since_s > limit_s) {
      beast::get_lowest_layer(socket).close();
      co_return;
    }
  }
}

// Applies sign-outs and account changes to an open connection: closes it, or changes the person's role.
template <typename Socket>
asio::awaitable<void> watch_rights(Socket& socket, std::shared_ptr<LiveHub::Member> member, std::string token,
                                   SharedState& shared) {
  while (!member->ended) {
    ErrorCode woken;
    member->next_check.expires_after(std::chrono::seconds(1));
    co_await member->next_check.async_wait(noting(woken));
    if (member->ended) co_return;
    const std::optional<Person> person = co_await person_now(token, shared);
    if (!person) {
      beast::get_lowest_layer(socket).close();
      co_return;
    }
    member->conversation.set_role(person->role);
  }
}

template <typename Stream>
asio::awaitable<void> talk(Stream& stream, const Request& request, Person person, SharedState& shared) {
  using Socket = websocket::stream<Stream&>;
  Socket socket(stream);
  socket.read_message_max(Conversation::most_message_bytes);
  websocket::stream_base::timeout limits{};
  limits.handshake_timeout = first_request_limit;
  limits.idle_timeout = std::chrono::seconds(10);
  limits.keep_alive_pings = true;
  socket.set_option(limits);
  beast::get_lowest_layer(socket).expires_never();
  ErrorCode failure;
  co_await socket.async_accept(request, noting(failure));
  if (failure) co_return;
  const std::shared_ptr<LiveHub::Member> member = shared.hub.join(std::move(person));
  SocketUsers users(co_await asio::this_coro::executor);
  users.start(write_all(socket, member));
  users.start(watch_writing(socket, member, shared.write_limit_s));
  users.start(watch_rights(socket, member, session_token(request), shared));
  const std::string complaint = co_await read_all(socket, *member, shared.hub);
  member->end();
  shared.hub.leave(member);
  if (!complaint.empty()) {
    shared.complaints.add("a console was refused: " + complaint, now_s());
    // A close frame has room for a reason of 123 bytes.
    co_await socket.async_close({websocket::close_code::policy_error, complaint.substr(0, 120)},
                                noting(failure));
  }
  beast::get_lowest_layer(socket).close();
  co_await users.wait();
}

/// The response to a request that could not be read; empty if the client has disconnected.
std::optional<ApiResponse> refusal_of(const ErrorCode& failure) {
  if (failure == http::error::body_limit) return refusal(413, "too-large", "the request is too large");
  if (failure == http::error::header_limit || failure == http::error::buffer_overflow)
    return refusal(431, "too-large", "the request's header is too large");
  if (failure.category() == make_error_code(http::error::bad_method).category() &&
      failure != http::error::end_of_stream && failure != http::error::partial_message)
    return refusal(400, "bad-request", "the request is malformed");
  return std::nullopt;
}

// Runs on a pool, so that requests that query the database or read pictures do not delay the live view.
asio::awaitable<Response> answer_on_pool(const Request& request, const HttpCaller& caller,
                                         SharedState& shared) {
  const auto path = request.target().substr(0, request.target().find('?'));
  const bool reads_all = request.method() == http::verb::get &&
                         (path == "/api/inspections" || path == "/api/trends" || path == "/api/trends.csv");
  co_return co_await asio::co_spawn(
      reads_all ? shared.lists : shared.pool,
      [&]() -> asio::awaitable<Response> { co_return http_answer(request, caller); }, asio::use_awaitable);
}

// The network of an IPv6 address, since a client that has one address of it has all of them.
std::string address_of(const beast::tcp_stream& stream) {
  ErrorCode gone;
  const asio::ip::address address = stream.socket().remote_endpoint(gone).address();
  if (!address.is_v6() || address.to_v6().is_v4_mapped()) return address.to_string();
  asio::ip::address_v6::bytes_type bytes = address.to_v6().to_bytes();
  std::fill(bytes.begin() + bytes.size() / 2, bytes.end(), std::uint8_t{0});
  return asio::ip::address_v6(bytes).to_string();
}

bool is_refused_sign_in(const Request& request, const Response& response) {
  return request.target() == "/api/sign-in" && (response.result() == http::status::unauthorized ||
                                                response.result() == http::status::too_many_requests);
}

// @return empty when the connection has become a WebSocket, and ended
template <typename Stream>
asio::awaitable<std::optional<Response>> answer(Stream& stream, const Request& request, SharedState& shared) {
  const HttpCaller caller{
      shared.api,    shared.files, shared.tls, shared.loopback, address_of(beast::get_lowest_layer(stream)),
      shared.metrics};
  if (!websocket::is_upgrade(request)) {
    const double asked_s = now_s();
    Response response = co_await answer_on_pool(request, caller, shared);
    shared.traffic.add_request(static_cast<int>(response.result_int()), now_s() - asked_s);
    if (is_refused_sign_in(request, response)) shared.complaints.add("a sign-in was refused", now_s());
    co_return response;
  }
  const std::variant<Person, ApiResponse> visitor = co_await asio::co_spawn(
      shared.pool,
      [&]() -> asio::awaitable<std::variant<Person, ApiResponse>> {
        try {
          co_return who_talks(request, caller);
        } catch (const Error& error) {
          co_return refusal(503, "unavailable", without_folders(error.what()));
        }
      },
      asio::use_awaitable);
  if (const auto* person = std::get_if<Person>(&visitor)) {
    co_await talk(stream, request, *person, shared);
    co_return std::nullopt;
  }
  shared.complaints.add("a WebSocket was refused", now_s());
  co_return http_response(std::get<ApiResponse>(visitor), false, shared.tls);
}

std::optional<Response> answer_to_nonsense(const ErrorCode& failure, SharedState& shared) {
  const std::optional<ApiResponse> refused = refusal_of(failure);
  if (!refused) return std::nullopt;
  shared.complaints.add("a request was refused: " + failure.message(), now_s());
  return http_response(*refused, false, shared.tls);
}

template <typename Stream>
asio::awaitable<void> serve_requests(Stream& stream, SharedState& shared, Registered& registered) {
  beast::flat_buffer buffer;
  for (bool first = true;; first = false) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(most_header_bytes);
    parser.body_limit(most_body_bytes);
    beast::get_lowest_layer(stream).expires_after(first ? first_request_limit : next_request_limit);
    ErrorCode failure;
    registered.set_idle(true);
    co_await http::async_read(stream, buffer, parser, noting(failure));
    registered.set_idle(false);
    std::optional<Response> response;
    if (failure)
      response = answer_to_nonsense(failure, shared);
    else
      response = co_await answer(stream, parser.get(), shared);
    if (!response) co_return;
    beast::get_lowest_layer(stream).expires_after(milliseconds_of(shared.write_limit_s));
    co_await http::async_write(stream, *response, noting(failure));
    if (failure || !response->keep_alive()) co_return;
  }
}

}  // namespace

asio::awaitable<void> serve(beast::tcp_stream stream, SharedState& shared) {
  Registered registered(shared, [&stream] { stream.close(); });
  co_await serve_requests(stream, shared, registered);
}

asio::awaitable<void> serve(beast::ssl_stream<beast::tcp_stream> stream, SharedState& shared) {
  Registered registered(shared, [&stream] { beast::get_lowest_layer(stream).close(); });
  beast::get_lowest_layer(stream).expires_after(first_request_limit);
  ErrorCode failure;
  co_await stream.async_handshake(asio::ssl::stream_base::server, noting(failure));
  if (failure) co_return;
  co_await serve_requests(stream, shared, registered);
}

}  // namespace rva
