#include "server/api.hpp"

#include <charconv>

#include "core/clock.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "server/health.hpp"
#include "server/private_paths.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

std::vector<std::string_view> segments(std::string_view path) {
  std::vector<std::string_view> parts;
  while (!path.empty()) {
    const std::size_t slash = path.find('/', 1);
    parts.push_back(path.substr(0, slash));
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash);
  }
  return parts;
}

// The parts of the path for which the route has {}; empty if the path does not match the route.
std::optional<std::vector<std::string>> match(std::string_view route, std::string_view path) {
  const std::vector<std::string_view> wanted = segments(route);
  const std::vector<std::string_view> given = segments(path);
  if (wanted.size() != given.size()) return std::nullopt;
  std::vector<std::string> path_parts;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == "/{}")
      path_parts.emplace_back(given[i].substr(1));
    else if (wanted[i] != given[i])
      return std::nullopt;
  }
  return path_parts;
}

}  // namespace

ApiResponse refusal(int status, const std::string& code, const std::string& message) {
  const Json body{{"error", {{"code", code}, {"message", message}}}};
  return {status, "application/json", json_text(body)};
}

Api::Api(const ServerParts& parts, bool secure_cookie) : parts_(parts), secure_cookie_(secure_cookie) {}

const std::vector<Api::Route>& Api::routes() {
  static const std::vector<Route> all{
      {"GET", "/api/health", std::nullopt, &Api::get_health},
      {"GET", "/api/session", std::nullopt, &Api::get_session},
      {"POST", "/api/sign-in", std::nullopt, &Api::sign_in},
      {"POST", "/api/sign-out", std::nullopt, &Api::sign_out},
      {"GET", "/api/inspections", PersonRole::viewer, &Api::list_inspections},
      {"POST", "/api/inspections", PersonRole::operator_, &Api::begin_inspection},
      {"GET", "/api/inspections/{}", PersonRole::viewer, &Api::get_inspection},
      {"DELETE", "/api/inspections/{}", PersonRole::operator_, &Api::remove_inspection},
      {"PUT", "/api/inspections/{}/views", PersonRole::operator_, &Api::set_views},
      {"PUT", "/api/inspections/{}/regions", PersonRole::operator_, &Api::set_regions},
      {"PUT", "/api/inspections/{}/views/{}/plan", PersonRole::operator_, &Api::set_plan},
      {"POST", "/api/inspections/{}/capture", PersonRole::operator_, &Api::take_side},
      {"POST", "/api/inspections/{}/compare", PersonRole::operator_, &Api::compare},
      {"GET", "/api/inspections/{}/rounds", PersonRole::viewer, &Api::get_rounds},
      {"GET", "/api/inspections/{}/report", PersonRole::viewer, &Api::get_report},
      {"GET", "/api/inspections/{}/report.pdf", PersonRole::viewer, &Api::get_pdf_report},
      {"POST", "/api/inspections/{}/findings/{}/decision", PersonRole::inspector, &Api::decide},
      {"POST", "/api/inspections/{}/decisions", PersonRole::inspector, &Api::decide_all},
      {"POST", "/api/inspections/{}/marked", PersonRole::operator_, &Api::mark},
      {"POST", "/api/inspections/{}/marked/{}/decision", PersonRole::inspector, &Api::decide_mark},
      {"POST", "/api/inspections/{}/close", PersonRole::inspector, &Api::close},
      {"POST", "/api/inspections/{}/items", PersonRole::operator_, &Api::check_out},
      {"POST", "/api/inspections/{}/items/{}", PersonRole::operator_, &Api::state_item},
      {"POST", "/api/inspections/{}/sign", PersonRole::operator_, &Api::sign},
      {"GET", "/api/trends", PersonRole::viewer, &Api::get_trends},
      {"GET", "/api/trends.csv", PersonRole::viewer, &Api::get_trends_csv},
      {"GET", "/api/keys", PersonRole::viewer, &Api::get_keys},
      {"GET", "/api/inspections/{}/views/{}/{}", PersonRole::viewer, &Api::get_picture},
      {"GET", "/api/inspections/{}/rounds/{}/views/{}/{}", PersonRole::viewer, &Api::get_round_picture},
      {"GET", "/api/inspections/{}/marked/{}/picture.png", PersonRole::viewer, &Api::get_marked_picture},
      {"GET", "/api/inspections/{}/baseline/{}/{}", PersonRole::viewer, &Api::get_baseline_picture},
      {"GET", "/api/inspections/{}/baseline-check", PersonRole::viewer, &Api::get_baseline_check},
      {"GET", "/api/inspections/{}/map", PersonRole::viewer, &Api::get_map},
      {"GET", "/api/inspections/{}/changes", PersonRole::viewer, &Api::get_changes},
      {"GET", "/api/inspections/{}/rounds/{}/map", PersonRole::viewer, &Api::get_map},
      {"GET", "/api/inspections/{}/rounds/{}/changes", PersonRole::viewer, &Api::get_changes},
      {"PUT", "/api/camera/exposure", PersonRole::operator_, &Api::set_exposure},
      {"PUT", "/api/robot/lamp", PersonRole::operator_, &Api::set_lamp},
      {"POST", "/api/readiness", PersonRole::operator_, &Api::check_readiness},
      {"GET", "/api/findable.png", PersonRole::viewer, &Api::get_findable},
      {"POST", "/api/cancel", PersonRole::operator_, &Api::cancel},
      {"POST", "/api/freeze", PersonRole::viewer, &Api::freeze},
      {"GET", "/api/frozen/{}/picture.png", PersonRole::viewer, &Api::get_frozen_picture},
      {"POST", "/api/inspections/{}/snapshots", PersonRole::operator_, &Api::keep_snapshot},
      {"GET", "/api/inspections/{}/snapshots/{}/picture.png", PersonRole::viewer, &Api::get_snapshot},
      {"POST", "/api/measure", PersonRole::viewer, &Api::measure_points},
      {"POST", "/api/inspections/{}/rounds/{}/views/{}/measure", PersonRole::viewer, &Api::measure_view},
      {"POST", "/api/inspections/{}/map/measure", PersonRole::viewer, &Api::measure_map},
      {"POST", "/api/inspections/{}/rounds/{}/map/measure", PersonRole::viewer, &Api::measure_map},
      {"POST", "/api/simulation", PersonRole::operator_, &Api::simulate_work},
  };
  return all;
}

ApiResponse Api::answer(const ApiRequest& request) const {
  try {
    return dispatch(request);
  } catch (const ApiError& error) {
    return refusal(error.status(), error.code(), without_folders(error.what()));
  } catch (const UsageError& error) {
    return refusal(400, "bad-request", without_folders(error.what()));
  } catch (const Error& error) {
    return refusal(409, "refused", without_folders(error.what()));
  } catch (const std::exception& error) {
    return refusal(500, "internal", "internal error: " + without_folders(printable(error.what())));
  }
}

ApiResponse Api::dispatch(const ApiRequest& request) const {
  bool known_path = false;
  for (const Route& route : routes()) {
    const auto path_parts = match(route.path, request.path);
    if (!path_parts) continue;
    known_path = true;
    if (route.method != request.method) continue;
    const std::optional<Person> who = person(request.token);
    require_role(route, who);
    return (this->*route.handler)({request, who, *path_parts, parse_body(request.body)});
  }
  if (known_path)
    return refusal(405, "method-not-allowed", request.method + " is not supported here; see docs/api.md");
  return refusal(404, "not-found", "there is nothing at this address; see docs/api.md");
}

std::optional<Person> Api::person(const std::string& token) const {
  if (!parts_.sessions.needed()) return Person{"", PersonRole::inspector};
  return parts_.sessions.person(token, steady_clock().now_s());
}

void Api::require_role(const Route& route, const std::optional<Person>& person) const {
  if (!route.least) return;
  if (!person) throw ApiError(401, "sign-in-required", "console", "you are not signed in", "sign in first");
  if (person->role < *route.least)
    throw ApiError(403, "not-allowed", person->name,
                   "is not allowed to do this in the role of " + std::string(name_of(person->role)),
                   "ask somebody with the required role");
}

// A capture turns the camera, so it must not begin while somebody else is driving.
void Api::require_robot_free(const Call& call) const {
  const auto holder = parts_.lease.holder(steady_clock().now_s());
  if (parts_.drive != nullptr && holder && holder->client != call.request.client)
    throw ApiError(409, "somebody-drives", "robot", printable(holder->name) + " is driving",
                   "ask them to let go, or take over");
}

std::int64_t Api::inspection_id(const Call& call) const {
  const std::string& text = call.path_parts.at(0);
  std::int64_t id = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (failure != std::errc{} || end != text.data() + text.size() || id < 1)
    throw ApiError(404, "not-found", "inspection", printable(text) + " is not a number",
                   "see the list of inspections");
  if (!parts_.inspector.has(id))
    throw ApiError(404, "not-found", "inspection " + text, "does not exist", "see the list of inspections");
  return id;
}

ApiResponse Api::get_health(const Call& /*call*/) const {
  const std::vector<HealthCheck> checks = check_health(parts_);
  return {is_healthy(checks) ? 200 : 503, "application/json", json_text(json_of(checks))};
}

// The name of the account; without accounts, the name that the request states.
std::string Api::person_of(const Call& call) {
  return call.person && !call.person->name.empty() ? call.person->name : text_field(call.body, "person");
}

}  // namespace rva
