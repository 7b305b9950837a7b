#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/intervals.hpp"
#include "core/quantile.hpp"
#include "evaluate/shake_study.hpp"
#include "evaluate/table.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

// The median and nine tenths of the stated directions' errors, "-" without one.
std::string errors_of(const std::vector<ShakeInspection>& inspections) {
  std::vector<double> off_deg;
  for (const ShakeInspection& inspection : inspections) {
    if (inspection.direction_off_deg && inspection.stated) off_deg.push_back(*inspection.direction_off_deg);
  }
  if (off_deg.empty()) return "-";
  return fmt::format("{:.0f}, {:.0f}", quantile(off_deg, 0.5), quantile(off_deg, 0.9));
}

}  // namespace

std::string to_table(const std::vector<ShakeInspection>& inspections, Shaken shaken) {
  const auto share = [&](bool ShakeInspection::*member) {
    return stated_share(static_cast<std::size_t>(std::ranges::count(inspections, true, member)),
                        inspections.size());
  };
  const auto rate = [&](std::size_t ShakeInspection::*member) {
    std::size_t sum = 0;
    for (const ShakeInspection& inspection : inspections) sum += inspection.*member;
    return stated_rate(sum, inspections.size());
  };
  std::vector<TableColumn> keys{{"moved"}};
  std::vector<TableColumn> columns{
      {"found"}, {"stated as loose"}, {"direction off, deg (50, 90 %)"}, {"other findings"}, {"loose parts"}};
  add_row(keys, {std::string(name_of(shaken))});
  const bool moved = shaken == Shaken::loose;
  add_row(columns,
          {moved ? share(&ShakeInspection::found) : "-", moved ? share(&ShakeInspection::stated) : "-",
           errors_of(inspections), rate(&ShakeInspection::others), rate(&ShakeInspection::pairs)});
  return table_of(keys, columns);
}

Json json_of(const std::vector<ShakeInspection>& inspections, Shaken shaken) {
  Json json{{"format", "rva-evaluation-shake"},
            {"version", 1},
            {"moved", name_of(shaken)},
            {"inspections", Json::array()}};
  for (const ShakeInspection& inspection : inspections) {
    Json& one = json["inspections"].emplace_back();
    one = {{"seed", inspection.seed},
           {"kind", inspection.kind},
           {"distance_m", inspection.distance_m},
           {"moved_mm", inspection.moved_mm},
           {"findings", inspection.findings},
           {"others", inspection.others},
           {"found", inspection.found},
           {"stated", inspection.stated},
           {"loose_parts", inspection.pairs}};
    if (inspection.direction_off_deg) one["direction_off_deg"] = *inspection.direction_off_deg;
  }
  return json;
}

}  // namespace rva
