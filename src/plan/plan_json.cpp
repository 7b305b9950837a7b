#include <nlohmann/json.hpp>

#include "plan/plan_match.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<AbsentPart>& parts) {
  Json list = Json::array();
  for (const AbsentPart& part : parts) {
    Json json = Json::object();
    if (part.place) json["place"] = *part.place;
    if (part.pixel) json["pixel"] = {part.pixel->x(), part.pixel->y()};
    list.push_back(json);
  }
  return list;
}

Json json_of(const PlannedGroup& group) {
  return {{"name", group.name},
          {"kind", name_of(group.kind)},
          {"planned", group.planned},
          {"found", group.found},
          {"missing", json_of(group.missing)},
          {"not_inspected", json_of(group.not_inspected)},
          {"findings", group.findings}};
}

Json json_of(const std::vector<LoosePiece>& pieces) {
  Json list = Json::array();
  for (const LoosePiece& piece : pieces) {
    Json json{{"finding", piece.finding},
              {"bbox", {piece.box.x, piece.box.y, piece.box.width, piece.box.height}},
              {"area_px", piece.area_px}};
    if (piece.height_mm) json["height_mm"] = *piece.height_mm;
    if (piece.item) json["item"] = *piece.item;
    list.push_back(json);
  }
  return list;
}

Json groups_of(const PlanMatch& match) {
  Json groups = Json::array();
  for (const PlannedGroup& group : match.groups) groups.push_back(json_of(group));
  return groups;
}

}  // namespace

Json json_of(const PlanMatch& match) {
  Json order = Json::array();
  for (const PlannedFinding& finding : match.findings) order.push_back(finding.id);
  return {{"format", "rva-plan-match"},
          {"version", 1},
          {"order", order},
          {"unplanned", json_of(match.unplanned)},
          {"groups", groups_of(match)},
          {"surplus", json_of(match.surplus)}};
}

void add_plan(const PlanMatch& match, Json& detections) {
  for (Json& finding : detections.at("detections")) {
    const auto state = std::ranges::find(match.findings, finding.at("id").get<int>(), &PlannedFinding::id);
    if (state == match.findings.end()) continue;
    finding["planned"] = name_of(state->state);
    if (state->item) finding["planned_item"] = *state->item;
  }
  detections["plan"] = groups_of(match);
}

}  // namespace rva
