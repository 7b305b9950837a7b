#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/path_text.hpp"
#include "report/inspection_report.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct ReportArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::string out;
  bool overwrite = false;
};

// The records and captures must outlast a mistyped name.
void require_outside(const fs::path& out, const fs::path& data) {
  std::error_code ignored;
  const fs::path within =
      fs::weakly_canonical(out, ignored).lexically_relative(fs::weakly_canonical(data, ignored));
  if (!within.empty() && *within.begin() != "..")
    throw Error(printable(out), "is in the folder of the inspections, in which a report replaces nothing",
                "choose another folder");
}

void write_report(const ReportArguments& arguments) {
  require_replaceable(arguments.out, arguments.overwrite);
  require_outside(arguments.out, arguments.data);
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
  add_recorded_inspection(command, arguments->data, arguments->inspection);
  command.add_option("--out", arguments->out, "the report, an HTML file")->required()->type_name("FILE");
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier file");
  command.callback([arguments] { write_report(*arguments); });
}

}  // namespace rva::cli
