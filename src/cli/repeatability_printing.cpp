#include "cli/repeatability_printing.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cli/printing.hpp"
#include "core/enum_names.hpp"

namespace rva::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Estimated& value) {
  return {{"value", value.value}, {"low", value.low}, {"high", value.high}};
}

OrderedJson json_of(const JointReturns& returns) {
  return {{"deviation_deg", json_of(returns.deviation)},
          {"most_off_deg", returns.most_off_deg},
          {"deviation_from_larger_deg", json_of(returns.deviation_larger)},
          {"most_off_from_larger_deg", returns.most_off_larger_deg},
          {"play_deg", json_of(returns.play)},
          {"noise_deg", json_of(returns.noise)}};
}

OrderedJson json_of(const PanTilt& joints) {
  return {{"pan_deg", joints.pan_deg}, {"tilt_deg", joints.tilt_deg}};
}

OrderedJson json_of(const JointTurn& turn) {
  return {{"pan_deg", turn.pan_deg},
          {"tilt_deg", turn.tilt_deg},
          {"rest_deg", turn.rest_deg},
          {"correlation", turn.correlation}};
}

OrderedJson json_of(const MeasuredReturn& back) {
  OrderedJson json = json_of(back.turn);
  json["pan_from"] = name_of(back.pan);
  json["tilt_from"] = name_of(back.tilt);
  json["reported"] = json_of(back.reported);
  return json;
}

OrderedJson json_of(const PoseReturns& pose) {
  OrderedJson json = json_of(pose.pose);
  json["reported"] = json_of(pose.reported);
  json["known_turn"] = json_of(pose.known);
  json["seen_turn"] = json_of(pose.seen);
  json["still"] = OrderedJson::array();
  for (const JointTurn& turn : pose.still) json["still"].push_back(json_of(turn));
  json["returns"] = OrderedJson::array();
  for (const MeasuredReturn& back : pose.returns) json["returns"].push_back(json_of(back));
  return json;
}

OrderedJson json_of(const Criterion& criterion) {
  return {{"joint", criterion.joint},
          {"name", criterion.name},
          {"deg", json_of(criterion.value)},
          {"limit_deg", criterion.limit_deg},
          {"fitness", name_of(criterion.fitness)}};
}

std::string cell(const Estimated& value) {
  return fmt::format("{:.3f} ({:.3f} to {:.3f})", value.value, value.low, value.high);
}

std::string cell(double value) { return fmt::format("{:.3f}", value); }

void print_row(std::string_view name, const auto& pan, const auto& tilt) {
  print("{:36} {:24} {}\n", name, cell(pan), cell(tilt));
}

void print_row_of_fine(std::string_view name, const Estimated& pan, const Estimated& tilt) {
  print("{:36} {:<24.4f} {:.4f}\n", name, pan.value, tilt.value);
}

std::string_view sentence_of(Fitness fitness) {
  switch (fitness) {
    case Fitness::fit:
      return "fit: it comes back within all limits";
    case Fitness::unfit:
      return "unfit: tighten the screws of the joints, and replace a servo that has worn gears";
    case Fitness::undecided:
      break;
  }
  return "undecided: measure more returns (--returns), or, where the noise is too large, with more light";
}

}  // namespace

nlohmann::ordered_json json_of(const Repeatability& measured, const RepeatabilitySummary& summary) {
  OrderedJson json = {{"format", "rva-repeatability"},       {"version", 1},
                      {"verdict", name_of(summary.verdict)}, {"pictures", measured.pictures},
                      {"returns", summary.returns},          {"pan", json_of(summary.pan)},
                      {"tilt", json_of(summary.tilt)},       {"most_rest_deg", summary.most_rest_deg},
                      {"criteria", OrderedJson::array()},    {"poses", OrderedJson::array()}};
  for (const Criterion& criterion : summary.criteria) json["criteria"].push_back(json_of(criterion));
  for (const PoseReturns& pose : measured.poses) json["poses"].push_back(json_of(pose));
  return json;
}

void print_summary(const Repeatability& measured, const RepeatabilitySummary& summary) {
  const JointReturns& pan = summary.pan;
  const JointReturns& tilt = summary.tilt;
  print("{} returns to {} pose(s), by pictures: {}\n\n", summary.returns, measured.poses.size(),
        measured.pictures);
  print("{:36} {:24} {}\n", "degrees, with intervals of 95 %", "pan", "tilt");
  print_row("from smaller angles, deviation", pan.deviation, tilt.deviation);
  print_row("  farthest from the first arrival", pan.most_off_deg, tilt.most_off_deg);
  print_row("from larger angles, deviation", pan.deviation_larger, tilt.deviation_larger);
  print_row("  farthest from the first arrival", pan.most_off_larger_deg, tilt.most_off_larger_deg);
  print_row("larger less smaller: play", pan.play, tilt.play);
  print_row_of_fine("noise of a picture without motion", pan.noise, tilt.noise);
  print("{:36} {:.3f}\n\n", "turn that no joint makes, at most", summary.most_rest_deg);
  for (const Criterion& criterion : summary.criteria) {
    if (criterion.fitness != Fitness::fit)
      print("{}: {} {:.4f} ({:.4f} to {:.4f}), limit {:g}: {}\n", criterion.joint, criterion.name,
            criterion.value.value, criterion.value.low, criterion.value.high, criterion.limit_deg,
            name_of(criterion.fitness));
  }
  print("{}\n", sentence_of(summary.verdict));
}

}  // namespace rva::cli
