#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/inspection_filter.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/intervals.hpp"
#include "core/path_text.hpp"
#include "report/trends.hpp"

namespace rva::cli {
namespace {

struct TrendsArguments {
  std::string data;
  InspectionFilterFlags filter;
  bool csv = false;
};

std::string hours_of(const Trend& trend) {
  const std::optional<double> hours = trend.median_hours();
  return hours ? fmt::format("{:.1f}", *hours) : "-";
}

// Fits 100 columns; a longer zone is cut off, which --csv does not do.
void print_trend(const std::string& zone, const std::string& month, const Trend& trend) {
  print("{:<24.24}  {:<7.7}  {:>11}  {:>6}  {:>6}  {:>9}  {:>12}  {:>4}\n", zone, month, trend.inspections,
        hours_of(trend), trend.found.any_debris(), trend.found.installed, trend.found.false_alarms,
        trend.marked.any_debris());
}

void print_trends(const Trends& trends) {
  print("{:<24}  {:<7}  {:>11}  {:>6}  {:>6}  {:>9}  {:>12}  {:>4}\n", "zone", "month", "inspections",
        "hours", "debris", "installed", "false alarms", "seen");
  for (const auto& [of, trend] : trends) print_trend(printable(of.zone), of.month, trend);
  const Trend sum = sum_of(trends);
  if (sum.comparisons == 0) return;
  print("false alarms per comparison: {}\n", stated_rate(sum.found.false_alarms, sum.comparisons));
  print("false alarms among what was found and decided on: {}\n",
        stated_share(sum.found.false_alarms, sum.decided()));
}

void show_trends(const TrendsArguments& arguments) {
  const Trends trends = trends_of(recorded_tallies(arguments.data, filter_of(arguments.filter)));
  if (arguments.csv)
    print("{}", csv_of(trends));
  else
    print_trends(trends);
}

}  // namespace

void add_trends_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "trends", "sums what inspections found by zone and month, with the rate of false alarms as reviewed");
  const auto arguments = std::make_shared<TrendsArguments>();
  add_data_folder(command, arguments->data);
  add_inspection_filter(command, arguments->filter);
  command.add_flag("--csv", arguments->csv, "as CSV (RFC 4180) with further columns, for spreadsheets");
  command.callback([arguments] { show_trends(*arguments); });
}

}  // namespace rva::cli
