#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/hidden_input.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/path_text.hpp"
#include "core/replaceable_file.hpp"
#include "report/inspection_report.hpp"
#include "report/pdf/pdf_report.hpp"
#include "report/pdf/pdf_signature.hpp"
#include "report/pdf/signing_certificate.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct ReportArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::string out;
  std::string pdf;
  std::string paper{name_of(Paper::a4)};
  std::string sign_with;
  std::string passphrase_file;
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

void require_formats(const ReportArguments& arguments) {
  if (arguments.out.empty() && arguments.pdf.empty())
    throw UsageError("rva inspection report", "has nothing to write", "give --out, --pdf or both");
  if (fs::path(arguments.out).lexically_normal() == fs::path(arguments.pdf).lexically_normal())
    throw UsageError(printable(arguments.out), "cannot be the HTML and the PDF file", "give them two names");
}

// The first line of the file, or what is typed.
std::string passphrase_of(const ReportArguments& arguments) {
  if (arguments.passphrase_file.empty())
    return read_password(fmt::format("Passphrase of {}: ", printable(arguments.sign_with)));
  const std::string text = read_text_file(arguments.passphrase_file);
  return text.substr(0, text.find_first_of("\r\n"));
}

// A certificate that cannot sign is refused before the report is made.
std::optional<SigningCertificate> certificate_for(const ReportArguments& arguments,
                                                  const std::string& made_at) {
  if (arguments.sign_with.empty()) return std::nullopt;
  SigningCertificate certificate =
      read_signing_certificate(arguments.sign_with, [&] { return passphrase_of(arguments); });
  require_valid(certificate, made_at);
  return certificate;
}

void write_report(const ReportArguments& arguments) {
  require_formats(arguments);
  require_writable(arguments, arguments.out);
  require_writable(arguments, arguments.pdf);
  const std::string made_at = time_of_making();
  const std::optional<SigningCertificate> certificate = certificate_for(arguments, made_at);
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  const ReportDocument report = report_on(history, InspectionFolder(arguments.data, arguments.inspection));
  std::string pdf;
  if (!arguments.pdf.empty()) pdf = pdf_report(report, *value_of<Paper>(arguments.paper));
  if (certificate) pdf = signed_pdf(pdf, *certificate, made_at);
  if (!arguments.out.empty()) {
    replace_file(arguments.out, html_report(report, made_at));
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
  CLI::Option* const sign_with =
      command
          .add_option("--sign-with", arguments->sign_with,
                      "PKCS#12 file (.p12) with the certificate and private key that sign --pdf")
          ->needs(pdf)
          ->type_name("FILE");
  command
      .add_option(
          "--passphrase-file", arguments->passphrase_file,
          "file whose first line is the passphrase of --sign-with; without it, the passphrase is typed "
          "or a line of stdin")
      ->needs(sign_with)
      ->type_name("FILE");
  command.add_flag("--overwrite", arguments->overwrite, "replace earlier files");
  command.callback([arguments] { write_report(*arguments); });
}

}  // namespace rva::cli
