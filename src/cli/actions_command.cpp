#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/csv_row.hpp"
#include "report/actions.hpp"
#include "server/signed_package.hpp"

namespace rva::cli {
namespace {

struct ActionsArguments {
  std::string data;
  std::string person;
};

struct InspectionAction {
  const InspectionOrder* order = nullptr;
  std::int64_t inspection = 0;
  std::string at;
  std::string person;
  std::string what;
};

// NAME+ID+BASE64
std::string name_in(const std::string& verifier_key) {
  return verifier_key.substr(0, verifier_key.find('+'));
}

// An account's name may contain spaces, the name of its key does not.
bool is_person(const std::string& name, std::string person, bool is_key_name) {
  if (is_key_name) std::ranges::replace(person, ' ', '_');
  return person.empty() || name == person;
}

std::vector<InspectionAction> actions_in(const InspectionHistory& history,
                                         const ActionsArguments& arguments) {
  const Inspection& inspection = history.inspection;
  std::vector<InspectionAction> actions;
  for (const Action& action : actions_of(history))
    if (is_person(action.person, arguments.person, false))
      actions.push_back({&inspection.order, inspection.id, action.at, action.person, words_of(action.what)});
  for (const SignedPackage& package : signed_packages(arguments.data, inspection.id))
    for (const std::string& key : package.signers)
      if (is_person(name_in(key), arguments.person, true))
        actions.push_back(
            {&inspection.order, inspection.id, package.signed_at, name_in(key), "Signed " + package.folder});
  return actions;
}

void print_actions(const ActionsArguments& arguments) {
  print("{}", csv_row({"time", "person", "inspection", "aircraft", "zone", "work_order", "action"}));
  visit_recorded(arguments.data, [&](const InspectionHistory& history) {
    for (const InspectionAction& action : actions_in(history, arguments))
      print("{}",
            csv_row({action.at, action.person, std::to_string(action.inspection), action.order->aircraft,
                     action.order->zone, action.order->work_order, action.what}));
  });
}

}  // namespace

void add_actions_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "actions", "prints every action in the records, of everybody or of one person, as CSV (RFC 4180)");
  const auto arguments = std::make_shared<ActionsArguments>();
  add_data_folder(command, arguments->data);
  command.add_option("--person", arguments->person, "only what this person did, by the exact name")
      ->type_name("NAME");
  command.callback([arguments] { print_actions(*arguments); });
}

}  // namespace rva::cli
