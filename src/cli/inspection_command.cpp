#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "audit/key_file.hpp"
#include "audit/package_writer.hpp"
#include "audit/site_keys.hpp"
#include "cli/commands.hpp"
#include "cli/hidden_input.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "cli/terminal_progress.hpp"
#include "cli/timestamp_server.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "server/signed_package.hpp"
#include "server/time_stamp_client.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct PackageArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::vector<std::string> keys;
  std::string log_key;
  std::string log;
  std::string timestamp_server;
  std::string out;
};

SigningKey signing_key(const std::string& file) {
  return read_signing_key(file, [](const PublicKey& key, const fs::path& of) {
    return read_password(fmt::format("Password of {} ({}): ", printable(key.name), printable(of)));
  });
}

// That of the server's log, where the server has one.
SigningKey log_key(const PackageArguments& arguments, const std::vector<SigningKey>& signers) {
  if (!arguments.log_key.empty()) return signing_key(arguments.log_key);
  const fs::path of_server = SiteKeys::log_key_file(fs::path(arguments.data) / site_keys_name);
  std::error_code ignored;
  return arguments.log.empty() && fs::exists(of_server, ignored) ? signing_key(of_server) : signers.front();
}

PackageSigning signing_from(const PackageArguments& arguments) {
  std::vector<SigningKey> signers;
  for (const std::string& file : arguments.keys) signers.push_back(signing_key(file));
  const fs::path log = arguments.log.empty() ? fs::path(arguments.data) / "log" : fs::path(arguments.log);
  return {signers, log_key(arguments, signers), log,
          time_stamping(arguments.timestamp_server, [](const Error& failure) {
            fmt::print(stderr, "rva: warning: {}; the package has no time stamp\n", failure.what());
          })};
}

void export_package(const PackageArguments& arguments) {
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  write_signed_package(history, arguments.data, arguments.out, signing_from(arguments), terminal_progress());
  if (!history.inspection.closing)
    fmt::print(stderr, "rva: warning: inspection {} is not closed; it was signed as it is now\n",
               arguments.inspection);
  print("{}\n", arguments.out);
}

void add_package_export(CLI::App& command) {
  CLI::App& exporting = *command.add_subcommand(
      "export", "writes an inspection with all its files as a package that is signed and in the site's log");
  const auto arguments = std::make_shared<PackageArguments>();
  add_recorded_inspection(exporting, arguments->data, arguments->inspection);
  exporting
      .add_option("--key", arguments->keys,
                  "private key of a person who signs (rva key create); give the option once for each")
      ->required()
      ->allow_extra_args(false)
      ->type_name("FILE");
  exporting
      .add_option("--log-key", arguments->log_key,
                  "private key of the site's log; by default that of the server (DIR/keys/log.key) or, where "
                  "there is "
                  "none or --log is given, the first --key")
      ->type_name("FILE");
  exporting.add_option("--log", arguments->log, "folder of the site's log; by default DIR/log")
      ->type_name("DIR");
  add_timestamp_server(exporting, arguments->timestamp_server);
  exporting.add_option("--out", arguments->out, "folder of the package")->required()->type_name("PACKAGE");
  exporting.callback([arguments] { export_package(*arguments); });
}

}  // namespace

void add_inspection_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "inspection",
      "lists inspections, reports on them, repeats their comparisons, signs them, and verifies signed ones");
  command.require_subcommand(1);
  add_package_export(command);
  add_verify_command(command);
  add_report_command(command);
  add_inspection_list_command(command);
  add_actions_command(command);
  add_rerun_command(command);
  add_trends_command(command);
}

}  // namespace rva::cli
