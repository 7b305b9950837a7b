#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/output_file.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/path_text.hpp"
#include "report/inspection_report.hpp"
#include "report/pdf/pdf_report.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct ReportArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::string out;
  std::string pdf;
  std::string paper{name_of(Paper::a4)};
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

void require_writable(const ReportArguments& arguments, const std::string& file) {
  if (file.empty()) return;
  require_replaceable(file, arguments.overwrite);
  require_outside(file, arguments.data);
}

void require_one_format(const ReportArguments& arguments) {
  if (arguments.out.empty() && arguments.pdf.empty())
    throw UsageError("rva inspection report", "has nothing to write", "give --out, --pdf or both");
}

void write_report(const ReportArguments& arguments) {
  require_one_format(arguments);
  require_writable(arguments, arguments.out);
  require_writable(arguments, arguments.pdf);
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  const ReportDocument report = report_on(history, InspectionFolder(arguments.data, arguments.inspection));
  const std::string pdf = arguments.pdf.empty() ? "" : pdf_report(report, *value_of<Paper>(arguments.paper));
  if (!arguments.out.empty()) {
    replace_file(arguments.out, html_report(report, time_of_making()));
    print("{}\n", arguments.out);
  }
  if (arguments.pdf.empty()) return;
  replace_file(arguments.pdf, pdf);
  print("{}\n", arguments.pdf);
}

}  // namespace

void add_report_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "report", "writes what was inspected, found and decided to read and print: as HTML, as PDF or as both");
  const auto arguments = std::make_shared<ReportArguments>();
  add_recorded_inspection(command, arguments->data, arguments->inspection);
  command.add_option("--out", arguments->out, "the report, an HTML file")->type_name("FILE");
  CLI::Option* const pdf =
      command.add_option("--pdf", arguments->pdf, "the report, a PDF file")->type_name("FILE");
  command.add_option("--paper", arguments->paper, "size of the pages of --pdf: a4 or letter")
      ->check(name_among<Paper>())
      ->needs(pdf)
      ->type_name("SIZE")
      ->capture_default_str();
  command.add_flag("--overwrite", arguments->overwrite, "replace earlier files");
  command.callback([arguments] { write_report(*arguments); });
}

}  // namespace rva::cli
