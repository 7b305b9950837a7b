#include "server/json_of.hpp"

#include <cmath>
#include <utility>

#include "detect/findings/height_fields.hpp"
#include "inspect/closing.hpp"
#include "server/private_paths.hpp"

namespace rva {
namespace {

// Rounds to a number of decimal places.
double rounded(double number, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(number * scale) / scale;
}

Json list_of(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json list_of(const std::vector<Polygon>& polygons) {
  Json list = Json::array();
  for (const Polygon& polygon : polygons) {
    list.push_back(Json::array());
    for (const Eigen::Vector2d& corner : polygon) list.back().push_back({corner.x(), corner.y()});
  }
  return list;
}

Json list_of(const std::vector<DetectionLevels>& by_distance) {
  Json list = Json::array();
  for (const DetectionLevels& level : by_distance) {
    list.push_back({{"from_m", rounded(level.from_m, 1)},
                    {"to_m", rounded(level.to_m, 1)},
                    {"median_mm", rounded(level.median_mm, 1)},
                    {"p90_mm", rounded(level.p90_mm, 1)}});
    if (level.width_mm) list.back()["width_mm"] = rounded(*level.width_mm, 1);
  }
  return list;
}

Json list_of(const std::vector<FindableShare>& findable) {
  Json list = Json::array();
  for (const FindableShare& share : findable)
    list.push_back({{"size_mm", share.size_mm}, {"share", rounded(share.share, 4)}});
  return list;
}

Json json_of(const NoiseSoFar& noise) {
  return {{"frames", noise.frames},
          {"measured", noise.measured},
          {"median_std_mm", rounded(noise.median_std_mm, 2)},
          {"findable",
           {{"judged", noise.findable.judged},
            {"window_px", noise.findable.window_px},
            {"by_distance", list_of(noise.findable.by_distance)},
            {"findable", list_of(noise.findable.findable)}}}};
}

Json json_of(const ItemStatement& statement) {
  return {{"returned", statement.returned},  {"used", statement.used}, {"lost", statement.lost},
          {"released", statement.released},  {"note", statement.note}, {"person", statement.person},
          {"stated_at", statement.stated_at}};
}

Json json_of(const CheckedOutItem& item) {
  Json statements = Json::array();
  for (const ItemStatement& statement : item.statements) statements.push_back(json_of(statement));
  return {{"number", item.number},
          {"name", item.item.name},
          {"identity", item.item.identity},
          {"quantity", item.item.quantity},
          {"person", item.person},
          {"taken_at", item.taken_at},
          {"state", name_of(state_of(item))},
          {"statements", std::move(statements)}};
}

Json json_of(const Closing& closing) {
  return {{"comparison", closing.comparison},
          {"person", closing.person},
          {"note", closing.note},
          {"closed_at", closing.closed_at}};
}

Json json_of(const MarkedFinding& marked) {
  const Box& box = marked.box;
  Json json{
      {"number", marked.number}, {"round", marked.round},   {"bbox", {box.x, box.y, box.width, box.height}},
      {"note", marked.note},     {"person", marked.person}, {"marked_at", marked.marked_at}};
  if (marked.view) {
    json["view"] = *marked.view;
    json["comparison"] = marked.comparison;
  }
  if (marked.position_m) json["position_m"] = list_of(*marked.position_m);
  if (marked.in_foot_m) json["in_foot_m"] = list_of(*marked.in_foot_m);
  if (marked.size_mm) json["size_mm"] = *marked.size_mm;
  if (marked.decision) json["decision"] = json_of(*marked.decision);
  return json;
}

Json json_of(const Snapshot& snapshot) {
  return {{"number", snapshot.number},
          {"note", snapshot.note},
          {"person", snapshot.person},
          {"taken_at", snapshot.taken_at}};
}

Json json_of(const PlannedWork& work) {
  return {{"name", work.name},   {"kind", name_of(work.kind)}, {"planned", work.planned},
          {"found", work.found}, {"missing", work.missing},    {"not_inspected", work.not_inspected}};
}

Json json_of(const ComparedView& view) {
  Json coverage{{"compared", view.coverage.compared},
                {"unseen", view.coverage.unseen},
                {"invalid", view.coverage.invalid}};
  if (view.coverage.left_out) coverage["left_out"] = *view.coverage.left_out;
  Json warnings = Json::array();
  for (const std::string& warning : view.warnings) warnings.push_back(without_folders(warning));
  Json json{{"view", view.view},     {"method", view.method}, {"coverage", coverage},
            {"judged", view.judged}, {"warnings", warnings},  {"findable", list_of(view.findable)}};
  for (const PlannedWork& work : view.planned) json["planned"].push_back(json_of(work));
  return json;
}

template <typename Values>
Json json_list(const Values& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(json_of(value));
  return list;
}

}  // namespace

Json json_of(const PanTilt& joints) { return {{"pan_deg", joints.pan_deg}, {"tilt_deg", joints.tilt_deg}}; }

Json json_of(const TakenSide& side) {
  return {{"taken_at", side.taken_at}, {"person", side.person}, {"base", side.base}, {"round", side.round}};
}

Json json_of(const Decision& decision) {
  Json json{{"verdict", name_of(decision.verdict)},
            {"note", decision.note},
            {"person", decision.person},
            {"decided_at", decision.decided_at},
            {"round", decision.round}};
  if (!decision.object.empty()) json["object"] = decision.object;
  return json;
}

Json json_of(const ReviewedFinding& reviewed) {
  const Finding& finding = reviewed.finding;
  const Box& box = finding.box;
  Json json{{"number", reviewed.number},
            {"view", reviewed.view},
            {"same_as", reviewed.same_as},
            {"kind", name_of(finding.kind)},
            {"bbox", {box.x, box.y, box.width, box.height}},
            {"centroid", {finding.centroid.x(), finding.centroid.y()}}};
  if (finding.position_m) json["position_m"] = list_of(*finding.position_m);
  if (reviewed.in_foot_m) json["in_foot_m"] = list_of(*reviewed.in_foot_m);
  if (finding.size_mm) json["size_mm"] = *finding.size_mm;
  add_heights(finding, json);
  if (reviewed.clear_px) json["clear_px"] = *reviewed.clear_px;
  if (finding.score) json["score"] = *finding.score;
  if (finding.p_value) json["p_value"] = *finding.p_value;
  json["evidence"] = Json::array();
  if (finding.evidence.depth) json["evidence"].push_back("depth");
  if (finding.evidence.appearance) json["evidence"].push_back("appearance");
  if (reviewed.moved_from) json["moved_from"] = *reviewed.moved_from;
  if (reviewed.planned) json["planned"] = name_of(*reviewed.planned);
  if (!reviewed.planned_item.empty()) json["planned_item"] = reviewed.planned_item;
  if (!reviewed.likely_class.empty()) json["class"] = reviewed.likely_class;
  if (reviewed.class_probability) json["probability"] = *reviewed.class_probability;
  if (reviewed.decision) json["decision"] = json_of(*reviewed.decision);
  return json;
}

Json json_of(const InspectionSummary& summary) {
  Json json{{"id", summary.id},
            {"aircraft", summary.order.aircraft},
            {"zone", summary.order.zone},
            {"work_order", summary.order.work_order},
            {"person", summary.order.person},
            {"created_at", summary.created_at},
            {"stage", name_of(summary.stage)},
            {"findings_count", summary.findings},
            {"undecided_count", summary.undecided}};
  if (summary.initial) json["initial"] = json_of(*summary.initial);
  if (summary.final) json["final"] = json_of(*summary.final);
  if (summary.comparison) {
    json["comparison"] = summary.comparison->number;
    json["compared_at"] = summary.comparison->compared_at;
  }
  if (summary.closing) json["closing"] = json_of(*summary.closing);
  return json;
}

Json json_of(const ComparedRound& round) {
  Json json{{"comparison", round.comparison.number},
            {"compared_at", round.comparison.compared_at},
            {"compared", json_list(round.compared)},
            {"findings", json_list(round.findings)}};
  if (round.final) json["final"] = json_of(*round.final);
  return json;
}

Json json_of(const Inspection& inspection) {
  Json json = json_of(summary_of(inspection));
  json["views"] = Json::array();
  for (std::size_t view = 0; view < inspection.views.size(); ++view) {
    json["views"].push_back(json_of(inspection.views[view]));
    const auto ignored = inspection.ignored.find(static_cast<int>(view));
    if (ignored != inspection.ignored.end() && !ignored->second.empty())
      json["views"].back()["ignore"] = list_of(ignored->second);
    if (const auto plan = inspection.planned.find(static_cast<int>(view)); plan != inspection.planned.end())
      json["views"].back()["plan"] = json_of(plan->second);
  }
  json["compared"] = json_list(inspection.compared);
  json["findings"] = json_list(inspection.findings);
  json["marked"] = json_list(inspection.marked);
  json["snapshots"] = json_list(inspection.snapshots);
  json["items"] = json_list(inspection.items);
  Json reasons = Json::array();
  for (const ClosingReason reason : reasons_for_note(inspection)) reasons.push_back(name_of(reason));
  json["closing_needs_note"] = !reasons.empty();
  json["closing_note_for"] = std::move(reasons);
  return json;
}

Json json_of(const Readiness& readiness) {
  Json items = Json::array();
  for (const ReadinessItem& item : readiness.items)
    items.push_back({{"name", item.name},
                     {"ready", item.ready},
                     {"says", without_folders(item.says)},
                     {"code", item.code},
                     {"values", item.values}});
  return {{"ready", readiness.ready()}, {"checked_at", readiness.checked_at}, {"items", items}};
}

Json json_of(const TaskState& task) {
  Json json{{"number", task.number}, {"kind", name_of(task.kind)}, {"end", name_of(task.end)}};
  if (task.inspection > 0) json["inspection"] = task.inspection;
  json["side"] = name_of(task.side);
  json["view"] = task.progress.view;
  json["views"] = task.progress.views;
  json["capture"] = task.progress.capture;
  json["captures"] = task.progress.captures;
  json["frame"] = task.progress.frame;
  json["frames"] = task.progress.frames;
  json["approach"] = task.progress.approach;
  json["approaches"] = task.progress.approaches;
  json["done"] = task.done;
  json["total"] = task.total;
  if (!task.waiting.empty()) json["waiting"] = without_folders(task.waiting);
  if (!task.problem.empty()) json["problem"] = without_folders(task.problem);
  if (task.noise) json["noise"] = json_of(*task.noise);
  return json;
}

namespace {

Json json_of(const LampState& lamp) {
  Json json{{"percent", lamp.percent}, {"too_hot", lamp.too_hot}};
  if (lamp.celsius) json["celsius"] = rounded(*lamp.celsius, 1);
  return json;
}

}  // namespace

Json json_of(const DriveState& state, const RobotLimits& limits) {
  Json json{
      {"driving", state.driving}, {"armed", state.armed}, {"lent", state.lent}, {"at_limit", state.at_limit}};
  if (state.joints) {
    json["pan_deg"] = rounded(state.joints->pan_deg, 2);
    json["tilt_deg"] = rounded(state.joints->tilt_deg, 2);
  }
  if (!state.problem.empty()) json["problem"] = without_folders(state.problem);
  json["limits"] = {{"pan_deg", {limits.pan.min_deg, limits.pan.max_deg}},
                    {"tilt_deg", {limits.tilt.min_deg, limits.tilt.max_deg}}};
  if (state.lamp) json["lamp"] = json_of(*state.lamp);
  return json;
}

}  // namespace rva
