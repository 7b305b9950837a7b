// The HTTP API (docs/api.md), independent of HTTP itself: requests in, responses out.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "server/json_of.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// A request of the console, independent of HTTP.
struct ApiRequest {
  std::string method;   ///< "GET", "POST", "PUT", "DELETE"
  std::string path;     ///< "/api/...", without the query
  std::string body;     ///< JSON, or empty
  std::string client;   ///< id of the console, the same as in its WebSocket
  std::string token;    ///< from the session cookie; empty if there is none
  std::string from;     ///< address of the client
  std::string query{};  ///< what follows the path's question mark, as it was sent
};

/// The answer to a request: an HTTP status and the body of that content type.
struct ApiResponse {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers{};
};

/// A refused request: the code is for programs, the message for people.
class ApiError : public Error {
 public:
  ApiError(int status, std::string code, const std::string& source, const std::string& problem,
           const std::string& remedy)
      : Error(source, problem, remedy), status_(status), code_(std::move(code)) {}
  [[nodiscard]] int status() const { return status_; }
  [[nodiscard]] const std::string& code() const { return code_; }

 private:
  int status_;
  std::string code_;
};

/// The response to a refused request, with the code and the message as JSON.
[[nodiscard]] ApiResponse refusal(int status, const std::string& code, const std::string& message);

/// Every member may be called from any thread.
class Api {
 public:
  /// @param secure_cookie whether browsers send the session cookie over TLS only
  Api(const ServerParts& parts, bool secure_cookie);

  /// Never throws: an error becomes a response.
  [[nodiscard]] ApiResponse answer(const ApiRequest& request) const;

  /// The person who is signed in with this token; empty if nobody is. Without accounts, everybody may do
  /// everything.
  [[nodiscard]] std::optional<Person> person(const std::string& token) const;

 private:
  /// A request whose route is known.
  struct Call {
    const ApiRequest& request;
    std::optional<Person> person;
    std::vector<std::string> path_parts;  ///< the parts of the path for which the route has {}
    Json body;                            ///< an object
  };
  using Handler = ApiResponse (Api::*)(const Call&) const;
  struct Route {
    std::string_view method;
    std::string_view path;
    std::optional<PersonRole> least;  ///< empty: allowed without signing in
    Handler handler;
  };
  static const std::vector<Route>& routes();

  [[nodiscard]] ApiResponse dispatch(const ApiRequest& request) const;
  void require_role(const Route& route, const std::optional<Person>& person) const;
  void require_robot_free(const Call& call) const;
  [[nodiscard]] std::int64_t inspection_id(const Call& call) const;
  [[nodiscard]] ApiResponse whole_inspection(std::int64_t id, int status = 200) const;
  [[nodiscard]] static std::string person_of(const Call& call);

  ApiResponse get_health(const Call& call) const;
  // server/session_routes.cpp
  ApiResponse get_session(const Call& call) const;
  ApiResponse sign_in(const Call& call) const;
  ApiResponse sign_out(const Call& call) const;
  // server/inspection_routes.cpp
  ApiResponse list_inspections(const Call& call) const;
  ApiResponse begin_inspection(const Call& call) const;
  ApiResponse get_inspection(const Call& call) const;
  ApiResponse remove_inspection(const Call& call) const;
  ApiResponse set_views(const Call& call) const;
  ApiResponse set_regions(const Call& call) const;
  ApiResponse set_plan(const Call& call) const;
  ApiResponse check_readiness(const Call& call) const;
  ApiResponse take_side(const Call& call) const;
  ApiResponse compare(const Call& call) const;
  ApiResponse cancel(const Call& call) const;
  // server/review_routes.cpp
  ApiResponse get_rounds(const Call& call) const;
  ApiResponse get_report(const Call& call) const;
  ApiResponse get_pdf_report(const Call& call) const;
  ApiResponse decide(const Call& call) const;
  ApiResponse decide_all(const Call& call) const;
  ApiResponse mark(const Call& call) const;
  ApiResponse decide_mark(const Call& call) const;
  ApiResponse keep_snapshot(const Call& call) const;
  ApiResponse close(const Call& call) const;
  // server/checkout_routes.cpp
  ApiResponse check_out(const Call& call) const;
  ApiResponse state_item(const Call& call) const;
  // server/signing_routes.cpp
  [[nodiscard]] PersonRole confirmed_role(const std::string& name, const std::string& password,
                                          const std::string& from) const;
  ApiResponse sign(const Call& call) const;
  ApiResponse get_keys(const Call& call) const;
  // server/trends_routes.cpp
  ApiResponse get_trends(const Call& call) const;
  ApiResponse get_trends_csv(const Call& call) const;
  // server/picture_routes.cpp
  ApiResponse get_picture(const Call& call) const;
  ApiResponse get_round_picture(const Call& call) const;
  ApiResponse get_marked_picture(const Call& call) const;
  ApiResponse get_frozen_picture(const Call& call) const;
  ApiResponse get_snapshot(const Call& call) const;
  ApiResponse get_baseline_picture(const Call& call) const;
  ApiResponse get_baseline_check(const Call& call) const;
  ApiResponse get_findable(const Call& call) const;
  [[nodiscard]] RecordedComparison comparison_of(const Call& call) const;
  ApiResponse get_map(const Call& call) const;
  ApiResponse get_changes(const Call& call) const;
  ApiResponse simulate_work(const Call& call) const;
  // server/measure_routes.cpp
  [[nodiscard]] std::vector<std::shared_ptr<const LiveFrame>> still_frames(
      std::shared_ptr<const LiveFrame> first) const;
  [[nodiscard]] std::shared_ptr<const FrozenPicture> frozen_in(const std::string& number) const;
  ApiResponse freeze(const Call& call) const;
  void require_no_capture(const std::string& what) const;
  ApiResponse set_exposure(const Call& call) const;
  ApiResponse set_lamp(const Call& call) const;
  ApiResponse measure_points(const Call& call) const;
  ApiResponse measure_view(const Call& call) const;
  ApiResponse measure_map(const Call& call) const;

  ServerParts parts_;
  bool secure_cookie_;
};

}  // namespace rva
