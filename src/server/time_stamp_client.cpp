#include "server/time_stamp_client.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <regex>
#include <string_view>
#include <utility>

#include "audit/time_stamp.hpp"
#include "core/interrupt.hpp"
#include "core/options.hpp"
#include "core/path_text.hpp"
#include "server/asio.hpp"

namespace rva {
namespace {

using namespace std::chrono_literals;

constexpr auto time_limit = 10s;
constexpr std::uint64_t most_answer_bytes = 256U << 10U;
constexpr const char* check_server = "check the time stamp server, and sign again for a time stamp";

/// Where a URL leads.
struct Location {
  std::string host;
  std::string port;
  std::string path;
};

std::optional<Location> location_of(const std::string& url) {
  static const std::regex form(R"(http://([A-Za-z0-9._-]+|\[[0-9A-Fa-f:.]+\])(:([0-9]{1,5}))?(/[!-~]*)?)");
  std::smatch parts;
  if (!std::regex_match(url, parts, form)) return std::nullopt;
  std::string host = parts[1];
  if (host.starts_with('[')) host = host.substr(1, host.size() - 2);
  return Location{host, parts[3].matched ? parts[3].str() : "80", parts[4].matched ? parts[4].str() : "/"};
}

/// What a server answered, or why it did not.
struct Reply {
  std::string body{};
  unsigned int status = 0;
  ErrorCode failure = beast::error::timeout;  ///< unless something else happens in time
};

asio::awaitable<void> post(const Location& to, const std::string& request, Reply& reply) {
  tcp::resolver resolver(co_await asio::this_coro::executor);
  beast::tcp_stream stream(co_await asio::this_coro::executor);
  stream.expires_after(time_limit);
  ErrorCode failure;
  const auto addresses = co_await resolver.async_resolve(to.host, to.port, noting(failure));
  if (!failure) co_await stream.async_connect(addresses, noting(failure));
  http::request<http::string_body> question(http::verb::post, to.path, 11, request);
  question.set(http::field::host, to.host);
  question.set(http::field::content_type, "application/timestamp-query");
  question.prepare_payload();
  if (!failure) co_await http::async_write(stream, question, noting(failure));
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> answer;
  answer.body_limit(most_answer_bytes);
  if (!failure) co_await http::async_read(stream, buffer, answer, noting(failure));
  // Beast does not always report a body beyond the limit.
  if (!failure && (!answer.is_done() || answer.get().body().size() > most_answer_bytes))
    failure = http::error::body_limit;
  reply.failure = failure;
  if (failure) co_return;
  reply.status = answer.get().result_int();
  reply.body = std::move(answer.get().body());
}

Reply reply_to(const Location& to, const std::string& request) {
  Reply reply;
  asio::io_context context;
  bool ended = false;
  asio::co_spawn(context, post(to, request, reply), [&ended](const std::exception_ptr&) { ended = true; });
  const auto end = std::chrono::steady_clock::now() + time_limit;
  while (!ended && std::chrono::steady_clock::now() < end) {
    throw_if_interrupted();
    context.run_for(100ms);
  }
  return reply;
}

std::string stamp_by(const std::string& url, const Location& location, std::string_view bytes) {
  const std::string request = time_stamp_request(bytes);
  const Reply reply = reply_to(location, request);
  if (reply.failure)
    throw Error(url, "did not answer (" + printable(reply.failure.message()) + ")", check_server);
  if (reply.status != static_cast<unsigned int>(http::status::ok))
    throw Error(url, fmt::format("answered with HTTP status {}", reply.status), check_server);
  return time_stamp_in(reply.body, request, url);
}

}  // namespace

TimeStamping time_stamping(const std::string& url, std::function<void(const Error& failure)> on_failure) {
  if (url.empty()) return {};
  const std::optional<Location> location = location_of(url);
  if (!location)
    throw OptionError("timestamp-server", printable(url) + " is no URL of the form http://HOST[:PORT][/PATH]",
                      "give the address of a time stamp server (RFC 3161)");
  return {url, [url, location = *location, on_failure = std::move(on_failure)](std::string_view bytes) {
            try {
              return stamp_by(url, location, bytes);
            } catch (const Error& failure) {
              on_failure(failure);
              throw;
            }
          }};
}

}  // namespace rva
