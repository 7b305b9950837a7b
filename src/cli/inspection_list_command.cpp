#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/inspection_filter.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/csv_row.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

struct ListArguments {
  std::string data;
  InspectionFilterFlags filter;
  bool csv = false;
};

// Fits 100 columns; longer texts are cut off, which --csv does not do.
void print_row(const std::array<std::string, 8>& cells) {
  print("{:>6}  {:<10.10}  {:<8.8}  {:<14.14}  {:<22.22}  {:<14.14}  {:>5}  {:>5}\n", cells[0], cells[1],
        cells[2], cells[3], cells[4], cells[5], cells[6], cells[7]);
}

void print_summaries(const std::vector<InspectionSummary>& summaries) {
  print_row({"number", "begun", "stage", "aircraft", "zone", "work order", "found", "open"});
  for (const InspectionSummary& summary : summaries)
    print_row({std::to_string(summary.id), summary.created_at, std::string(name_of(summary.stage)),
               printable(summary.order.aircraft), printable(summary.order.zone),
               printable(summary.order.work_order), std::to_string(summary.findings),
               std::to_string(summary.undecided)});
}

void print_summaries_csv(const std::vector<InspectionSummary>& summaries) {
  print("{}", csv_row({"number", "begun_at", "begun_by", "stage", "aircraft", "zone", "work_order",
                       "baseline_at", "final_at", "findings", "undecided", "closed_at", "closed_by"}));
  for (const InspectionSummary& summary : summaries)
    print("{}", csv_row({std::to_string(summary.id), summary.created_at, summary.order.person,
                         std::string(name_of(summary.stage)), summary.order.aircraft, summary.order.zone,
                         summary.order.work_order, summary.initial ? summary.initial->taken_at : "",
                         summary.final ? summary.final->taken_at : "", std::to_string(summary.findings),
                         std::to_string(summary.undecided), summary.closing ? summary.closing->closed_at : "",
                         summary.closing ? summary.closing->person : ""}));
}

void list_inspections(const ListArguments& arguments) {
  const std::vector<InspectionSummary> summaries =
      recorded_summaries(arguments.data, filter_of(arguments.filter));
  arguments.csv ? print_summaries_csv(summaries) : print_summaries(summaries);
}

}  // namespace

void add_inspection_list_command(CLI::App& inspection) {
  CLI::App& command =
      *inspection.add_subcommand("list", "lists inspections, newest first, or those that are searched for");
  const auto arguments = std::make_shared<ListArguments>();
  add_data_folder(command, arguments->data);
  add_inspection_filter(command, arguments->filter);
  command.add_flag("--csv", arguments->csv, "as CSV (RFC 4180) with further columns, for spreadsheets");
  command.callback([arguments] { list_inspections(*arguments); });
}

}  // namespace rva::cli
