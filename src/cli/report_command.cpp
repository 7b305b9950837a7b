#include <cstdint>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "report/inspection_report.hpp"

namespace rva::cli {
namespace {

struct ReportArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::string out;
  bool overwrite = false;
};

void write_report(const ReportArguments& arguments) {
  require_replaceable(arguments.out, arguments.overwrite);
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  replace_file(
      arguments.out,
      inspection_report(history, InspectionFolder(arguments.data, arguments.inspection), time_of_making()));
  print("{}\n", arguments.out);
}

}  // namespace

void add_report_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "report", "writes what was inspected, found and decided as one HTML file to read and print");
  const auto arguments = std::make_shared<ReportArguments>();
  command.add_option("--data", arguments->data, "folder of inspections, as for rva serve")
      ->required()
      ->type_name("DIR");
  command.add_option("--inspection", arguments->inspection, "number of the inspection")
      ->required()
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command.add_option("--out", arguments->out, "the report, an HTML file")->required()->type_name("FILE");
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier file");
  command.callback([arguments] { write_report(*arguments); });
}

}  // namespace rva::cli
