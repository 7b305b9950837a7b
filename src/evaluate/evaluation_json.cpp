#include "evaluate/evaluation_json.hpp"

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/intervals.hpp"
#include "core/json_object.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Target& target) {
  return {{"kind", target.kind},
          {"visible_px", target.visible_px},
          {"unhidden_px", target.unhidden_px},
          {"distance_m", target.distance_m},
          {"shown_px", target.shown_px}};
}

Json json_of(const Result& result) {
  return {{"frames", result.frames},
          {"method", result.detector.method},
          {"setting", result.detector.setting},
          {"false_when_clean", result.false_when_clean},
          {"false_with_debris", result.false_with_debris},
          {"found", result.found},
          {"found_when_clean", result.found_when_clean}};
}

Json json_of(const Tally& tally) {
  const auto interval = [](const Interval& of) { return Json{of.low, of.high}; };
  return {
      {"frames", tally.frames},
      {"method", tally.detector.method},
      {"setting", tally.detector.setting},
      {"inspections", tally.inspections},
      {"false_when_clean", tally.false_when_clean},
      {"false_rate_95", interval(rate_interval(tally.false_when_clean, tally.inspections))},
      {"false_with_debris", tally.false_with_debris},
      {"found", tally.found},
      {"targets", tally.targets},
      {"found_when_clean", tally.found_when_clean},
      {"found_share_95", interval(share_interval(tally.found, tally.targets))},
      {"shown_found", tally.shown_found},
      {"shown_targets", tally.shown_targets},
      {"shown_share_95", interval(share_interval(tally.shown_found, tally.shown_targets))},
      {"small_found", tally.small_found},
      {"small_targets", tally.small_targets},
      {"small_share_95", interval(share_interval(tally.small_found, tally.small_targets))},
      {"small_shown_found", tally.small_shown_found},
      {"small_shown_targets", tally.small_shown_targets},
      {"small_shown_share_95", interval(share_interval(tally.small_shown_found, tally.small_shown_targets))},
      {"all_found", tally.all_found}};
}

Json json_of(const SimulatedInspection& inspection) {
  Json json{{"seed", inspection.seed}, {"targets", Json::array()}, {"results", Json::array()}};
  for (const Target& target : inspection.targets) json["targets"].push_back(json_of(target));
  for (const Result& result : inspection.results) json["results"].push_back(json_of(result));
  return json;
}

Target target_from(const nlohmann::json& json) {
  Target target;
  json.at("kind").get_to(target.kind);
  json.at("visible_px").get_to(target.visible_px);
  json.at("unhidden_px").get_to(target.unhidden_px);
  json.at("distance_m").get_to(target.distance_m);
  json.at("shown_px").get_to(target.shown_px);
  return target;
}

Result result_from(const nlohmann::json& json) {
  Result result;
  json.at("frames").get_to(result.frames);
  json.at("method").get_to(result.detector.method);
  json.at("setting").get_to(result.detector.setting);
  json.at("false_when_clean").get_to(result.false_when_clean);
  json.at("false_with_debris").get_to(result.false_with_debris);
  json.at("found").get_to(result.found);
  json.at("found_when_clean").get_to(result.found_when_clean);
  return result;
}

Evaluation evaluation_from(const nlohmann::json& json) {
  Evaluation evaluation{json.at("scene"), json.value("cameras", "d435"), json.value("bay", ""), {}};
  for (const nlohmann::json& one : json.at("inspections")) {
    SimulatedInspection inspection{one.at("seed").get<std::uint64_t>(), {}, {}};
    for (const nlohmann::json& target : one.at("targets")) inspection.targets.push_back(target_from(target));
    for (const nlohmann::json& result : one.at("results")) {
      inspection.results.push_back(result_from(result));
      if (inspection.results.back().found.size() != inspection.targets.size() ||
          inspection.results.back().found_when_clean.size() != inspection.targets.size())
        throw nlohmann::json::other_error::create(0, "found and targets differ in number", &result);
    }
    evaluation.inspections.push_back(std::move(inspection));
  }
  return evaluation;
}

}  // namespace

Json json_of(const Evaluation& evaluation) {
  Json json{{"format", "rva-evaluation"},
            {"version", 1},
            {"scene", evaluation.scene},
            {"cameras", evaluation.cameras},
            {"bay", evaluation.bay}};
  json["tallies"] = Json::array();
  for (const Tally& of : tally(evaluation.inspections)) json["tallies"].push_back(json_of(of));
  json["inspections"] = Json::array();
  for (const SimulatedInspection& inspection : evaluation.inspections)
    json["inspections"].push_back(json_of(inspection));
  return json;
}

Evaluation evaluation_from_json(const std::string& text, const std::string& source) {
  const nlohmann::json json = parse_json(text, source);
  try {
    return evaluation_from(json);
  } catch (const nlohmann::json::exception& exception) {
    throw Error(source, std::string("is not an evaluation that can be resumed: ") + exception.what(),
                "choose another output folder");
  }
}

}  // namespace rva
