#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "audit/key_file.hpp"
#include "audit/package_check.hpp"
#include "audit/package_files.hpp"
#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

using Json = nlohmann::ordered_json;

struct VerifyArguments {
  std::string package;
  std::vector<std::string> keys;
  std::string log;
  std::string checkpoint;
  std::string timestamp_ca;
  bool json = false;
};

KnownFromElsewhere known_from(const VerifyArguments& arguments) {
  KnownFromElsewhere known;
  for (const std::string& file : arguments.keys) known.keys.push_back(read_public_key(file));
  if (!arguments.log.empty()) known.log = arguments.log;
  if (!arguments.checkpoint.empty()) known.checkpoint = arguments.checkpoint;
  if (!arguments.timestamp_ca.empty()) known.time_stamp_ca = arguments.timestamp_ca;
  return known;
}

// Null where no server was asked.
Json time_stamp_of(const CheckedPackage& checked) {
  const auto& stated = checked.statement.time_stamp;
  if (!stated) return nullptr;
  Json json{{"server", stated->server}};
  if (checked.time_stamp) {
    json["time"] = checked.time_stamp->time;
    json["authority"] = checked.time_stamp->authority;
  } else {
    json["failure"] = stated->failure;
  }
  return json;
}

Json json_of(const CheckedPackage& checked, const VerifyArguments& arguments) {
  const Statement& statement = checked.statement;
  return {{"verified", true},
          {"inspection", statement.inspection.number},
          {"aircraft", statement.inspection.aircraft},
          {"zone", statement.inspection.zone},
          {"work_order", statement.inspection.work_order},
          {"made_at", statement.made_at},
          {"files", checked.files},
          {"bytes", checked.bytes},
          {"signers", statement.signers},
          {"time_stamp", time_stamp_of(checked)},
          {"log", {{"key", statement.log}, {"index", checked.index}, {"size", checked.log_size}}},
          {"compared_with",
           {{"keys", !arguments.keys.empty()},
            {"log", !arguments.log.empty()},
            {"checkpoint", !arguments.checkpoint.empty()},
            {"timestamp_ca", !arguments.timestamp_ca.empty()}}}};
}

void print_signers(const CheckedPackage& checked) {
  const char* heading = "signed by:";
  for (const PublicKey& key : checked.signers) {
    print("  {:<12}{}\n", heading, printable(name_with_id(key)));
    heading = "";
  }
}

void print_time_stamp(const CheckedPackage& checked) {
  const auto& stated = checked.statement.time_stamp;
  if (const auto& stamp = checked.time_stamp)
    print("  {:<12}{} by {}; {}\n", "time stamp:", stamp->time, printable(stamp->authority),
          stamp->authority_checked ? "the authority was checked against --timestamp-ca"
                                   : "whose authority it is was not checked: give --timestamp-ca");
  else
    print("  {:<12}none: {}\n",
          "time stamp:", stated ? printable(stated->server + " " + stated->failure) : "no server was asked");
}

// What was not checked is stated, since a person could take it for granted.
void print_comparisons(const VerifyArguments& arguments) {
  print("  {:<12}{}\n", "keys:",
        arguments.keys.empty() ? "those in the package: who they belong to was not checked; give --key"
                               : "as given with --key");
  const bool compared = !arguments.log.empty() || !arguments.checkpoint.empty();
  print("  {:<12}{}\n", "later log:",
        compared ? "has this record and what was known before"
                 : "not compared: whether records were taken back was not checked; give --log");
}

void print_text(const CheckedPackage& checked, const VerifyArguments& arguments) {
  const StatedInspection& inspection = checked.statement.inspection;
  print("{}: every file is as it was signed\n", printable(arguments.package));
  print("  {:<12}{} of aircraft {}, zone {}, work order {}\n", "inspection:", inspection.number,
        printable(inspection.aircraft), printable(inspection.zone), printable(inspection.work_order));
  print("  {:<12}{} files, {} bytes; packed {}\n", "content:", checked.files, checked.bytes,
        printable(checked.statement.made_at));
  print_signers(checked);
  print_time_stamp(checked);
  print("  {:<12}record {} of {} in the log of {}\n", "log:", checked.index + 1, checked.log_size,
        printable(name_with_id(checked.log_key)));
  print_comparisons(arguments);
}

void verify(const VerifyArguments& arguments) {
  const CheckedPackage checked = check_package(arguments.package, known_from(arguments));
  if (arguments.json) {
    print("{}\n", json_text(json_of(checked, arguments), 1));
  } else {
    print_text(checked, arguments);
  }
}

}  // namespace

void add_verify_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "verify", "checks that a package is as it was signed, and states by whom; needs no records");
  const auto arguments = std::make_shared<VerifyArguments>();
  command.add_option("PACKAGE", arguments->package, "folder of a package (rva inspection export)")
      ->required();
  command
      .add_option(
          "--key", arguments->keys,
          "public key of a signer or of the log, from a source that is trusted; give the option once for "
          "each: then nobody else may have signed")
      ->allow_extra_args(false)
      ->type_name("FILE");
  command
      .add_option(
          "--log", arguments->log,
          "copy of the site's log as it is now: then it has to contain the record and what was before it")
      ->type_name("DIR");
  command
      .add_option(
          "--checkpoint", arguments->checkpoint,
          "checkpoint of the log, or record.tlog-proof of another package, that was kept: then the log "
          "has to contain it, too")
      ->type_name("FILE");
  command
      .add_option("--timestamp-ca", arguments->timestamp_ca,
                  "certificates (PEM) of the CAs whose time stamps are trusted: then the package has to have "
                  "one")
      ->type_name("FILE");
  command.add_flag("--json", arguments->json, "print JSON instead of text");
  command.callback([arguments] { verify(*arguments); });
}

}  // namespace rva::cli
