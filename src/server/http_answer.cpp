#include "server/http_answer.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "server/metrics.hpp"

namespace rva {
namespace {

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

std::string_view view_of(beast::string_view text) { return {text.data(), text.size()}; }

std::string_view field(const Request& request, std::string_view name) {
  return view_of(request[beast::string_view(name.data(), name.size())]);
}

// Other host names are refused, since they may lead here by DNS rebinding.
bool is_known_host(std::string_view host, bool loopback) {
  if (!loopback) return true;
  const std::size_t colon = host.rfind(':');
  const std::string_view name = host.ends_with(']') ? host : host.substr(0, colon);
  constexpr std::array<std::string_view, 3> ours{"localhost", "127.0.0.1", "[::1]"};
  return std::ranges::find(ours, name) != ours.end();
}

bool is_same_origin(const Request& request, bool tls) {
  const std::string own = std::string(tls ? "https://" : "http://") + std::string(field(request, "Host"));
  return field(request, "Origin") == own;
}

std::string_view path_of(const Request& request) {
  const std::string_view target = view_of(request.target());
  return target.substr(0, target.find('?'));
}

std::string_view query_of(const Request& request) {
  const std::string_view target = view_of(request.target());
  const std::size_t mark = target.find('?');
  return mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
}

ApiResponse wrong_origin() {
  return refusal(403, "wrong-origin", "the requesting page is not this server's console");
}

bool has_no_weight(const http::param_list& parameters) {
  return std::ranges::any_of(parameters, [](const auto& parameter) {
    return beast::iequals(parameter.first, "q") && !parameter.second.empty() &&
           view_of(parameter.second).find_first_not_of("0.") == std::string_view::npos;
  });
}

// RFC 9110, section 12.5.3: a weight of 0 refuses a coding, and * stands for all that are not named. Codings
// are parsed one by one, since Beast 1.74 gives a coding without parameters those of the one before it.
bool accepts_gzip(const Request& request) {
  bool accepts_others = false;
  std::string_view codings = field(request, "Accept-Encoding");
  while (!codings.empty()) {
    const std::size_t end = std::min(codings.find(','), codings.size());
    for (const auto& [coding, parameters] : http::ext_list({codings.data(), end})) {
      if (beast::iequals(coding, "gzip")) return !has_no_weight(parameters);
      if (coding == "*") accepts_others = !has_no_weight(parameters);
    }
    codings.remove_prefix(std::min(end + 1, codings.size()));
  }
  return accepts_others;
}

ApiResponse file_answer(const ConsoleFile& file, const Request& request) {
  ApiResponse answer{200, file.content_type, file.bytes};
  answer.headers.emplace_back("Cache-Control",
                              file.immutable ? "public, max-age=31536000, immutable" : "no-cache");
  if (file.gzip.empty()) return answer;
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  if (!accepts_gzip(request)) return answer;
  answer.body = file.gzip;
  answer.headers.emplace_back("Content-Encoding", "gzip");
  return answer;
}

ApiResponse api_answer(const Request& request, const HttpCaller& caller) {
  const bool reads = request.method() == http::verb::get;
  // A form of another page cannot send JSON, and states its origin.
  if (!reads && !field(request, "Content-Type").starts_with("application/json"))
    return refusal(415, "not-json", "requests that change something must be JSON; set Content-Type");
  if (!reads && request.count("Origin") > 0 && !is_same_origin(request, caller.tls)) return wrong_origin();
  return caller.api.answer({std::string(view_of(request.method_string())), std::string(path_of(request)),
                            request.body(), std::string(field(request, "X-RVA-Client")),
                            session_token(request), caller.from, std::string(query_of(request))});
}

ApiResponse answer_of(const Request& request, const HttpCaller& caller) {
  if (!is_known_host(field(request, "Host"), caller.loopback))
    return refusal(421, "wrong-host", "this server does not have that name");
  const std::string_view path = path_of(request);
  if (path.starts_with("/api/")) return api_answer(request, caller);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refusal(405, "method-not-allowed", "only GET is supported here");
  if (path == "/metrics" && caller.metrics) return {200, metrics_content_type, caller.metrics()};
  const ConsoleFile* file = caller.files.find(std::string(path));
  return file == nullptr ? refusal(404, "not-found", "there is nothing at this address")
                         : file_answer(*file, request);
}

}  // namespace

std::string session_token(const http::request<http::string_body>& request) {
  constexpr std::string_view name = "rva_session=";
  std::string_view cookies = field(request, "Cookie");
  while (!cookies.empty()) {
    const std::size_t end = cookies.find(';');
    std::string_view cookie = cookies.substr(0, end);
    cookie.remove_prefix(std::min(cookie.find_first_not_of(' '), cookie.size()));
    if (cookie.starts_with(name)) return std::string(cookie.substr(name.size()));
    if (end == std::string_view::npos) break;
    cookies.remove_prefix(end + 1);
  }
  return {};
}

Response http_response(const ApiResponse& answer, bool keep_alive, bool tls) {
  Response response;
  response.version(11);
  response.result(static_cast<unsigned>(answer.status));
  response.set(http::field::content_type, answer.content_type);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Content-Security-Policy",
               "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
               "form-action 'none'; frame-ancestors 'none'");
  if (tls) response.set("Strict-Transport-Security", "max-age=31536000");
  response.set(http::field::cache_control, "no-store");
  for (const auto& [name, value] : answer.headers) response.set(name, value);
  response.body() = answer.body;
  response.keep_alive(keep_alive);
  response.prepare_payload();
  return response;
}

Response http_answer(const Request& request, const HttpCaller& caller) {
  Response response = http_response(answer_of(request, caller), request.keep_alive(), caller.tls);
  if (request.method() == http::verb::head) response.body().clear();
  return response;
}

std::variant<Person, ApiResponse> who_talks(const Request& request, const HttpCaller& caller) {
  if (path_of(request) != "/api/live") return refusal(404, "not-found", "there is nothing at this address");
  if (!is_known_host(field(request, "Host"), caller.loopback) || !is_same_origin(request, caller.tls))
    return wrong_origin();
  std::optional<Person> person = caller.api.person(session_token(request));
  if (!person) return refusal(401, "sign-in-required", "you are not signed in");
  return std::move(*person);
}

}  // namespace rva
