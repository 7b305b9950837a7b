#include "evaluate/moved_evaluation_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/intervals.hpp"
#include "core/json_object.hpp"
#include "evaluate/moved_tally.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Interval& interval) { return {interval.low, interval.high}; }

Json json_of(const MovedTally& of) {
  return {{"method", of.method},
          {"captures", of.captures},
          {"setting", of.setting},
          {"inspections", of.inspections},
          {"false_when_clean", of.false_when_clean},
          {"false_rate_95", json_of(rate_interval(of.false_when_clean, of.inspections))},
          {"false_with_debris", of.false_with_debris},
          {"work_findings", of.work_findings},
          {"trace_findings", of.trace_findings},
          {"targets", of.targets},
          {"found", of.found},
          {"found_share_95", json_of(share_interval(of.found, of.targets))},
          {"big", of.big},
          {"big_found", of.big_found},
          {"big_share_95", json_of(share_interval(of.big_found, of.big))},
          {"large", of.large},
          {"large_found", of.large_found}};
}

Json json_of(const MovedInspection& inspection) {
  Json json{{"seed", inspection.seed},         {"move_m", inspection.move_m},
            {"turn_deg", inspection.turn_deg}, {"matcher", inspection.matcher},
            {"ambient", inspection.ambient},   {"targets", Json::array()},
            {"results", Json::array()}};
  json["off_baseline_deg"] = inspection.off_baseline_deg;
  json["approaches"] = inspection.approaches;
  for (const MovedTarget& of : inspection.targets)
    json["targets"].push_back(Json{{"kind", of.target.kind},
                                   {"visible_px", of.target.visible_px},
                                   {"unhidden_px", of.target.unhidden_px},
                                   {"distance_m", of.target.distance_m},
                                   {"big", of.big},
                                   {"seen_free", of.seen_free}});
  for (const MovedRegistration& of : inspection.registrations) {
    Json& registration = json["registrations"].emplace_back(Json{{"method", of.method},
                                                                 {"captures", of.captures},
                                                                 {"error_mm", of.error_mm},
                                                                 {"error_deg", of.error_deg},
                                                                 {"doubt", of.doubt}});
    if (of.normalised) registration["normalised"] = *of.normalised;
  }
  for (const MovedResult& of : inspection.results)
    json["results"].push_back(Json{{"method", of.method},
                                   {"captures", of.captures},
                                   {"setting", of.setting},
                                   {"false_when_clean", of.false_when_clean},
                                   {"false_with_debris", of.false_with_debris},
                                   {"work_findings", of.work_findings},
                                   {"trace_findings", of.trace_findings},
                                   {"found", of.found}});
  return json;
}

MovedInspection inspection_from(const nlohmann::json& json) {
  MovedInspection inspection;
  json.at("seed").get_to(inspection.seed);
  json.at("move_m").get_to(inspection.move_m);
  json.at("turn_deg").get_to(inspection.turn_deg);
  json.at("matcher").get_to(inspection.matcher);
  json.at("ambient").get_to(inspection.ambient);
  inspection.off_baseline_deg = json.value("off_baseline_deg", 0.0);
  inspection.approaches = json.value("approaches", 1.0);
  for (const nlohmann::json& of : json.at("targets")) {
    MovedTarget target;
    of.at("kind").get_to(target.target.kind);
    of.at("visible_px").get_to(target.target.visible_px);
    of.at("unhidden_px").get_to(target.target.unhidden_px);
    of.at("distance_m").get_to(target.target.distance_m);
    of.at("big").get_to(target.big);
    of.at("seen_free").get_to(target.seen_free);
    inspection.targets.push_back(std::move(target));
  }
  for (const nlohmann::json& of : json.value("registrations", nlohmann::json::array())) {
    inspection.registrations.push_back({.method = of.at("method"),
                                        .captures = of.at("captures"),
                                        .error_mm = of.at("error_mm"),
                                        .error_deg = of.at("error_deg"),
                                        .doubt = of.at("doubt")});
    if (of.contains("normalised")) inspection.registrations.back().normalised = of.at("normalised");
  }
  for (const nlohmann::json& of : json.at("results")) {
    inspection.results.push_back({.method = of.at("method"),
                                  .captures = of.at("captures"),
                                  .setting = of.at("setting"),
                                  .false_when_clean = of.at("false_when_clean"),
                                  .false_with_debris = of.at("false_with_debris"),
                                  .work_findings = of.value("work_findings", std::size_t{0}),
                                  .trace_findings = of.value("trace_findings", std::size_t{0}),
                                  .found = of.at("found")});
    if (inspection.results.back().found.size() != inspection.targets.size())
      throw nlohmann::json::other_error::create(0, "found and targets differ in number", &of);
  }
  return inspection;
}

Json json_of(const CollarDetection& of) {
  Json json{{"method", of.method}, {"captures", of.captures}, {"setting", of.setting}, {"from_m", of.from_m},
            {"to_m", of.to_m},     {"collars", of.collars},   {"found", of.found}};
  if (!of.sizes) return json;
  json["a50_mm"] = of.sizes->a50_mm;
  json["a90_mm"] = of.sizes->a90_mm;
  if (of.sizes->a90_95_mm) json["a90_95_mm"] = *of.sizes->a90_95_mm;
  return json;
}

}  // namespace

Json json_of(const std::vector<MovedInspection>& inspections, const std::string& arguments) {
  Json json{{"format", "rva-evaluation-moved"}, {"version", 2}, {"arguments", arguments}};
  json["tallies"] = Json::array();
  for (const MovedTally& of : tally(inspections)) json["tallies"].push_back(json_of(of));
  json["probability_of_detection"] = Json::array();
  for (const CollarDetection& of : collar_detection(inspections))
    json["probability_of_detection"].push_back(json_of(of));
  json["inspections"] = Json::array();
  for (const MovedInspection& inspection : inspections) json["inspections"].push_back(json_of(inspection));
  return json;
}

std::vector<MovedInspection> moved_inspections_from_json(const std::string& text, const std::string& source,
                                                         const std::string& arguments) {
  const nlohmann::json json = parse_json(text, source);
  try {
    if (json.at("arguments").get<std::string>() != arguments)
      throw OptionError("resume", "the evaluation that is there was begun with other options",
                        "give the options that it was begun with, or another folder");
    std::vector<MovedInspection> inspections;
    for (const nlohmann::json& one : json.at("inspections")) inspections.push_back(inspection_from(one));
    return inspections;
  } catch (const nlohmann::json::exception& exception) {
    throw Error(source, std::string("is no evaluation to go on with: ") + exception.what(),
                "choose another folder");
  }
}

}  // namespace rva
