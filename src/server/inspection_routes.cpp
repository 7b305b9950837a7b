#include <charconv>
#include <cmath>

#include "core/date_time.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

ApiResponse json_answer(const Json& body, int status = 200) {
  return {status, "application/json", json_text(body)};
}

ApiResponse started() { return {202, "application/json", "{}"}; }

std::vector<PanTilt> views_in(const Json& body) {
  const auto found = body.find("views");
  if (found == body.end() || !found->is_array())
    throw ApiError(400, "bad-request", "views", "is not a list", "see docs/api.md");
  std::vector<PanTilt> views;
  for (const Json& view : *found)
    views.push_back({number_field(view, "pan_deg"), number_field(view, "tilt_deg")});
  return views;
}

// The number of the comparison that a request refers to, by its number or, from older consoles, by its time.
// 0 if it is none.
int comparison_in(const Json& body, const Inspection& inspection) {
  if (body.contains("comparison")) {
    const double number = number_field(body, "comparison");
    constexpr double most = 1e9;
    return number >= 1.0 && number <= most && number == std::floor(number) ? static_cast<int>(number) : 0;
  }
  const std::string compared_at = text_field(body, "compared_at");
  const bool same = inspection.comparison && inspection.comparison->compared_at == compared_at;
  return same ? inspection.comparison->number : 0;
}

}  // namespace

ApiResponse Api::list_inspections(const Call& /*call*/) const {
  Json list = Json::array();
  for (const InspectionSummary& summary : parts_.inspector.summaries()) list.push_back(json_of(summary));
  return json_answer({{"inspections", list}});
}

ApiResponse Api::begin_inspection(const Call& call) const {
  const std::int64_t id =
      parts_.inspector.begin({text_field(call.body, "aircraft"), text_field(call.body, "zone"),
                              text_field(call.body, "work_order"), person_of(call)});
  return json_answer(json_of(parts_.inspector.inspection(id)), 201);
}

ApiResponse Api::get_inspection(const Call& call) const {
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  Json json = json_of(inspection);
  if (const auto replaced = parts_.inspector.replaced_before_final(inspection))
    json["final_begun"] = {{"replaced", *replaced}};
  return json_answer(json);
}

ApiResponse Api::set_views(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.set_views(id, views_in(call.body));
  return json_answer(json_of(parts_.inspector.inspection(id)));
}

ApiResponse Api::set_regions(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const auto ignore = call.body.find("ignore");
  if (ignore == call.body.end())
    throw ApiError(400, "bad-request", "ignore", "is missing", "see docs/api.md");
  const double view = number_field(call.body, "view");
  if (!(view >= 0.0 && view < 1000.0))
    throw ApiError(404, "not-found", "view", "does not exist", "give one of the inspection's views");
  const Json regions{{"format", "rva-regions"}, {"version", 1}, {"ignore", *ignore}};
  parts_.inspector.set_ignored(id, static_cast<int>(view),
                               parse_regions(json_text(regions), "regions").ignore);
  return json_answer(json_of(parts_.inspector.inspection(id)));
}

ApiResponse Api::check_readiness(const Call& /*call*/) const {
  parts_.inspector.check_readiness();
  return started();
}

ApiResponse Api::take_side(const Call& call) const {
  const std::optional<Side> side = value_of<Side>(text_field(call.body, "side"));
  if (!side) throw ApiError(400, "bad-request", "side", "is neither initial nor final", "see docs/api.md");
  require_robot_free(call);
  parts_.inspector.capture(inspection_id(call), *side, person_of(call), flag_field(call.body, "replaced"));
  return started();
}

ApiResponse Api::compare(const Call& call) const {
  parts_.inspector.compare(inspection_id(call));
  return started();
}

ApiResponse Api::cancel(const Call& /*call*/) const {
  parts_.inspector.cancel();
  return started();
}

ApiResponse Api::decide(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const std::string& text = call.path_parts.at(1);
  int number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size())
    throw ApiError(404, "not-found", "finding", printable(text) + " is not a number",
                   "see the list of findings");
  const std::optional<Verdict> verdict = value_of<Verdict>(text_field(call.body, "verdict"));
  if (!verdict)
    throw ApiError(400, "bad-request", "verdict", "is missing or unknown",
                   "give debris-removed, installed-work, false-alarm or second-look");
  parts_.inspector.decide(
      id, comparison_in(call.body, parts_.inspector.inspection(id)), number,
      {*verdict, text_field(call.body, "note", most_note_bytes), person_of(call), iso_8601_now()});
  return json_answer(json_of(parts_.inspector.inspection(id)));
}

}  // namespace rva
