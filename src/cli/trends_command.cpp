#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/csv.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/path_text.hpp"
#include "evaluate/intervals.hpp"
#include "report/trends.hpp"

namespace rva::cli {
namespace {

struct TrendsArguments {
  std::string data;
  bool csv = false;
};

std::size_t debris_of(const VerdictCounts& counts) {
  return counts.debris + counts.removed + counts.unreachable;
}

std::string hours_of(const Trend& trend) {
  const std::optional<double> hours = trend.median_hours();
  return hours ? fmt::format("{:.1f}", *hours) : "-";
}

// Fits 100 columns; a longer zone is cut off, which --csv does not do.
void print_trend(const std::string& zone, const std::string& month, const Trend& trend) {
  print("{:<24.24}  {:<7.7}  {:>11}  {:>6}  {:>6}  {:>9}  {:>12}  {:>4}\n", zone, month, trend.inspections,
        hours_of(trend), debris_of(trend.found), trend.found.installed, trend.found.false_alarms,
        debris_of(trend.marked));
}

void print_trends(const Trends& trends) {
  print("{:<24}  {:<7}  {:>11}  {:>6}  {:>6}  {:>9}  {:>12}  {:>4}\n", "zone", "month", "inspections",
        "hours", "debris", "installed", "false alarms", "seen");
  for (const auto& [of, trend] : trends) print_trend(printable(of.zone), of.month, trend);
  const Trend sum = sum_of(trends);
  if (sum.comparisons == 0) return;
  const std::size_t decided = sum.found.all() - sum.found.undecided;
  print("false alarms per comparison: {}\n", stated_rate(sum.found.false_alarms, sum.comparisons));
  print("false alarms among what was found and decided on: {}\n",
        stated_share(sum.found.false_alarms, decided));
}

void print_trends_csv(const Trends& trends) {
  print_csv_row({"zone", "month", "inspections", "closed", "median_hours", "comparisons", "debris_removed",
                 "debris_left", "debris_unreachable", "installed_work", "false_alarms", "undecided",
                 "marked_debris", "marked_other"});
  for (const auto& [of, trend] : trends) {
    std::vector<std::string> row{of.zone, of.month};
    const auto add = [&](std::size_t count) { row.push_back(std::to_string(count)); };
    add(trend.inspections);
    add(trend.closed);
    const std::optional<double> hours = trend.median_hours();
    row.push_back(hours ? fmt::format("{:.3f}", *hours) : "");
    for (const std::size_t count :
         {trend.comparisons, trend.found.removed, trend.found.debris, trend.found.unreachable,
          trend.found.installed, trend.found.false_alarms, trend.found.undecided, debris_of(trend.marked),
          trend.marked.all() - debris_of(trend.marked)})
      add(count);
    print_csv_row(row);
  }
}

void show_trends(const TrendsArguments& arguments) {
  Trends trends;
  visit_recorded(arguments.data, [&](const InspectionHistory& history) { add_to(trends, history); });
  arguments.csv ? print_trends_csv(trends) : print_trends(trends);
}

}  // namespace

void add_trends_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "trends", "sums what inspections found by zone and month, with the rate of false alarms as reviewed");
  const auto arguments = std::make_shared<TrendsArguments>();
  add_data_folder(command, arguments->data);
  command.add_flag("--csv", arguments->csv, "as CSV (RFC 4180) with further columns, for spreadsheets");
  command.callback([arguments] { show_trends(*arguments); });
}

}  // namespace rva::cli
