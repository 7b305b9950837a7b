#include <set>

#include "core/json_object.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "server/api.hpp"
#include "server/inspection_filter.hpp"
#include "server/query.hpp"
#include "server/request_body.hpp"
#include "server/signed_package.hpp"

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

}  // namespace

ApiResponse Api::list_inspections(const Call& call) const {
  Json list = Json::array();
  const std::set<std::int64_t> signed_ones = signed_inspections(parts_.inspector.data());
  for (const InspectionSummary& summary :
       parts_.inspector.summaries(filter_in(query_values(call.request.query)))) {
    list.push_back(json_of(summary));
    if (signed_ones.contains(summary.id)) list.back()["has_signature"] = true;
  }
  return json_answer({{"inspections", list}});
}

ApiResponse Api::begin_inspection(const Call& call) const {
  const std::int64_t id =
      parts_.inspector.begin({text_field(call.body, "aircraft"), text_field(call.body, "zone"),
                              text_field(call.body, "work_order"), person_of(call)});
  return whole_inspection(id, 201);
}

ApiResponse Api::whole_inspection(std::int64_t id, int status) const {
  const Inspection inspection = parts_.inspector.inspection(id);
  Json json = json_of(inspection);
  if (const auto replaced = parts_.inspector.replaced_before_final(inspection))
    json["final_begun"] = {{"replaced", *replaced}};
  for (const SignedPackage& package : signed_packages(parts_.inspector.data(), id))
    json["signed"].push_back(
        {{"folder", package.folder}, {"signed_at", package.signed_at}, {"signers", package.signers}});
  if (json.contains("signed")) json["has_signature"] = true;
  return json_answer(json, status);
}

ApiResponse Api::get_inspection(const Call& call) const { return whole_inspection(inspection_id(call)); }

ApiResponse Api::remove_inspection(const Call& call) const {
  parts_.inspector.remove(inspection_id(call));
  return json_answer(Json::object());
}

ApiResponse Api::set_views(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.set_views(id, views_in(call.body));
  return whole_inspection(id);
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
  return whole_inspection(id);
}

// A plan file as text: empty removes the plan.
ApiResponse Api::set_plan(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const std::optional<int> view = number_in_path(call.path_parts.at(1));
  if (!view) throw ApiError(404, "not-found", "view", "does not exist", "give one of the inspection's views");
  const std::string text = text_field(call.body, "text", most_plan_bytes);
  const std::optional<Plan> plan = text.empty() ? std::nullopt : std::optional(parse_plan(text, "plan"));
  parts_.inspector.set_plan(id, *view, plan ? &*plan : nullptr);
  return whole_inspection(id);
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

}  // namespace rva
