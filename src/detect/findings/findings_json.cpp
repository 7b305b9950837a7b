#include <nlohmann/json.hpp>

#include "detect/findings/findings.hpp"
#include "detect/findings/height_fields.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Evidence& evidence) {
  Json json = Json::array();
  if (evidence.depth) json.push_back("depth");
  if (evidence.appearance) json.push_back("appearance");
  return json;
}

// @param of_two true if depth and infrared or colour images were compared, so that the evidence is stated
Json json_of(const Finding& finding, bool of_two) {
  Json json;
  json["id"] = finding.id;
  json["kind"] = name_of(finding.kind);
  json["bbox"] = {finding.box.x, finding.box.y, finding.box.width, finding.box.height};
  json["area_px"] = finding.pixels.size();
  json["centroid"] = {finding.centroid.x(), finding.centroid.y()};
  if (const auto& p = finding.position_m) json["position_m"] = {p->x(), p->y(), p->z()};
  if (finding.size_mm) json["size_mm"] = *finding.size_mm;
  add_heights(finding, json);
  if (finding.score) json["score"] = *finding.score;
  if (finding.p_value) json["p_value"] = *finding.p_value;
  if (finding.moved_from) json["moved_from"] = *finding.moved_from;
  if (of_two) json["evidence"] = json_of(finding.evidence);
  return json;
}

Json json_of(const Coverage& coverage) {
  Json json{{"compared", coverage.compared}, {"unseen", coverage.unseen}, {"invalid", coverage.invalid}};
  if (coverage.beyond_clip) json["beyond_clip"] = *coverage.beyond_clip;
  if (coverage.left_out) json["left_out"] = *coverage.left_out;
  return json;
}

}  // namespace

void add_heights(const Finding& finding, Json& json) {
  if (finding.height_mm) json["height_mm"] = *finding.height_mm;
  if (finding.above_surroundings_mm) {
    json["above_surroundings_mm"] = *finding.above_surroundings_mm;
    if (finding.height_mm) json["background_jump"] = finding.background_jump;
  }
  if (finding.top_above_surroundings_mm) {
    json["top_above_surroundings_mm"] = *finding.top_above_surroundings_mm;
    json["top_is_least"] = finding.top_is_least;
  }
}

Json json_of(const Findings& findings) {
  Json json;
  json["format"] = "rva-detections";
  json["version"] = 1;
  json["method"] = findings.method;
  json["parameters"] = Json::object();
  for (const auto& [name, value] : findings.parameters) {
    std::visit([&, &key = name](auto number) { json["parameters"][key] = number; }, value);
  }
  json["frames"] = {{"initial", findings.initial_frames}, {"final", findings.final_frames}};
  json["final_from_initial"] = to_row_major(findings.final_from_initial);
  json["coverage"] = json_of(findings.coverage);
  if (findings.appearance_judged) json["coverage"]["appearance"] = *findings.appearance_judged;
  const Runtime& runtime = findings.runtime;
  json["runtime_ms"] = {{"load", runtime.load_ms},
                        {"statistics", runtime.statistics_ms},
                        {"detect", runtime.detect_ms},
                        {"regions", runtime.regions_ms},
                        {"total", runtime.total_ms}};
  json["detections"] = Json::array();
  for (const Finding& finding : findings.findings)
    json["detections"].push_back(json_of(finding, findings.appearance_judged.has_value()));
  return json;
}

}  // namespace rva
