#include "evaluate/moved_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "core/intervals.hpp"
#include "core/quantile.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/thesis/octree_detection.hpp"
#include "evaluate/moved_tally.hpp"
#include "evaluate/table.hpp"

namespace rva {
namespace {

/// Of all inspections with so many captures a side.
struct Registrations {
  std::vector<double> mm;   ///< of those that were trusted
  std::vector<double> deg;  ///< likewise
  std::size_t within = 0;   ///< 4 mm and 0.25 degrees
  std::size_t refused = 0;
  std::size_t trusted_and_wrong = 0;  ///< off by more than 20 mm or a degree
  std::vector<double> normalised;     ///< of those that state a covariance
  std::size_t as_claimed = 0;         ///< of these, within the 95 % that their covariance claims
};

// With six degrees of freedom.
constexpr double chi_squared_50 = 5.348;
constexpr double chi_squared_95 = 12.592;

void add(const MovedRegistration& one, Registrations& sum) {
  if (!one.doubt.empty()) {
    ++sum.refused;
    return;
  }
  sum.mm.push_back(one.error_mm);
  sum.deg.push_back(one.error_deg);
  sum.within += one.error_mm < 4.0 && one.error_deg < 0.25 ? 1 : 0;
  sum.trusted_and_wrong += one.error_mm > 20.0 || one.error_deg > 1.0 ? 1 : 0;
  if (!one.normalised) return;
  sum.normalised.push_back(*one.normalised);
  sum.as_claimed += *one.normalised <= chi_squared_95 ? 1 : 0;
}

/// By method and captures a side.
std::map<std::pair<std::string, int>, Registrations> registrations_of(
    const std::vector<MovedInspection>& inspections) {
  std::map<std::pair<std::string, int>, Registrations> all;
  for (const MovedInspection& inspection : inspections) {
    for (const MovedRegistration& one : inspection.registrations) add(one, all[{one.method, one.captures}]);
  }
  return all;
}

struct Share {
  std::size_t found = 0;
  std::size_t all = 0;
};

bool is_usual(const MovedResult& result) {
  return result.setting ==
         (result.method == "octree" ? OctreeOptions{}.cell_m : CalibratedOptions{}.false_findings);
}

// "0.4 to 0.6 m"
std::string distance_of(const MovedTarget& target) {
  constexpr double step_m = 0.2;
  const double from_m = step_m * std::floor(target.target.distance_m / step_m);
  return fmt::format("at {:.1f} to {:.1f} m", from_m, from_m + step_m);
}

/// By what a row is about (kind of debris, distance, light), method and captures a side.
using Shares = std::map<std::tuple<std::string, std::string, int>, Share>;

void add(const MovedInspection& inspection, const MovedResult& result, Shares& shares) {
  for (std::size_t i = 0; i < inspection.targets.size(); ++i) {
    const MovedTarget& target = inspection.targets[i];
    if (!target.counts()) continue;
    const std::string size = target.big ? "big" : "small";
    for (const std::string& row : {target.target.kind, fmt::format("{}, {}", size, distance_of(target)),
                                   fmt::format("{}, light {:g}", size, inspection.ambient),
                                   fmt::format("{}, {}", size, inspection.matcher)}) {
      Share& share = shares[{row, result.method, result.captures}];
      share.found += result.found[i] ? 1 : 0;
      ++share.all;
    }
  }
}

Shares shares_at_usual_setting(const std::vector<MovedInspection>& inspections) {
  Shares shares;
  for (const MovedInspection& inspection : inspections) {
    for (const MovedResult& result : inspection.results) {
      if (is_usual(result)) add(inspection, result, shares);
    }
  }
  return shares;
}

// "a90 9.1 mm, a90/95 11.3 mm"
std::string stated_sizes(const std::optional<DetectionSizes>& sizes) {
  if (!sizes) return "no curve fits";
  return fmt::format("a90 {:.1f} mm, a90/95 {}", sizes->a90_mm,
                     sizes->a90_95_mm ? fmt::format("{:.1f} mm", *sizes->a90_95_mm) : "not proven");
}

// Of studies in which each pose was approached more than once.
std::string stated_return(const std::vector<MovedInspection>& inspections) {
  std::vector<double> off_deg;
  double approaches = 0.0;
  for (const MovedInspection& inspection : inspections) {
    off_deg.push_back(inspection.off_baseline_deg);
    approaches += inspection.approaches / static_cast<double>(inspections.size());
  }
  if (approaches <= 1.0) return "";
  return fmt::format(
      "poses: {:.1f} approaches each, {:.3f} degrees from the baseline's in the median inspection\n",
      approaches, quantile(off_deg, 0.5));
}

std::string table_of_tallies(const std::vector<MovedTally>& tallies) {
  std::vector<TableColumn> keys{{"method"}, {"captures"}, {"setting"}};
  std::vector<TableColumn> columns{{"false each, unchanged"},
                                   {"false each, debris"},
                                   {"big debris found"},
                                   {"of that over 120 px"},
                                   {"all debris found"}};
  for (const MovedTally& of : tallies) {
    add_row(keys, {of.method, std::to_string(of.captures), fmt::format("{:g}", of.setting)});
    add_row(columns, {stated_rate(of.false_when_clean, of.inspections),
                      stated_rate(of.false_with_debris, of.inspections), stated_share(of.big_found, of.big),
                      stated_share(of.large_found, of.large), stated_share(of.found, of.targets)});
  }
  return table_of(keys, columns);
}

// What the registrations of a method with so many captures a side were worth. Sorts their errors.
std::string stated(const std::string& method, int captures, Registrations& of) {
  const std::string head = fmt::format("{:8}  {:>8}  ", method, captures);
  if (of.mm.empty()) return fmt::format("{}registration: all {} refused\n", head, of.refused);
  std::string text = fmt::format(
      "{}registration: median {:.2f} mm, {:.3f} degrees\n"
      "{:20}{} of {} within 4 mm and 0.25 degrees; {} refused; {} trusted and wrong\n",
      head, quantile(of.mm, 0.5), quantile(of.deg, 0.5), "", of.within, of.mm.size() + of.refused, of.refused,
      of.trusted_and_wrong);
  if (of.normalised.empty()) return text;
  return text + fmt::format(
                    "{:20}errors within the 95 % of the stated covariance: {}\n"
                    "{:20}median of their squares in deviations: {:.1f}, where {:.1f} is expected\n",
                    "", stated_share(of.as_claimed, of.normalised.size()), "", quantile(of.normalised, 0.5),
                    chi_squared_50);
}

}  // namespace

std::string to_table(const std::vector<MovedInspection>& inspections) {
  std::string text = table_of_tallies(tally(inspections)) + stated_return(inspections);
  for (auto& [key, of] : registrations_of(inspections)) text += stated(key.first, key.second, of);
  for (const auto& [key, share] : shares_at_usual_setting(inspections)) {
    const auto& [kind, method, captures] = key;
    fmt::format_to(std::back_inserter(text), "{:8}  {:>8}  {:26} {}\n", method, captures, kind,
                   stated_share(share.found, share.all));
  }
  for (const CollarDetection& of : collar_detection(inspections)) {
    if (of.collars == 0) continue;
    fmt::format_to(std::back_inserter(text), "{:8}  {:>8}  {:>7}  collars at {:.1f} to {:.1f} m: {}\n",
                   of.method, of.captures, fmt::format("{:g}", of.setting), of.from_m, of.to_m,
                   stated_share(of.found, of.collars));
    fmt::format_to(std::back_inserter(text), "{:29}{}\n", "", stated_sizes(of.sizes));
  }
  return text;
}

}  // namespace rva
