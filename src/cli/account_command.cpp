#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/hidden_input.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "inspect/person_name.hpp"
#include "server/password.hpp"
#include "store/sqlite_records.hpp"

namespace rva::cli {
namespace {

struct AccountArguments {
  std::string name;
  std::string role;
  std::string data;
};

std::unique_ptr<SqliteRecords> open_records(const std::string& data) {
  std::error_code failure;
  std::filesystem::create_directories(data, failure);
  return std::make_unique<SqliteRecords>(std::filesystem::path(data) / "rva.db");
}

// An existing account keeps its role unless another one is given.
PersonRole role_of(const AccountArguments& arguments, const Accounts& accounts) {
  if (const auto given = value_of<PersonRole>(arguments.role)) return *given;
  for (const Account& account : accounts.accounts()) {
    if (account.name == arguments.name) return account.role;
  }
  return PersonRole::viewer;
}

void add_account(const AccountArguments& arguments) {
  constexpr std::size_t most_name_bytes = 100;
  if (arguments.name.size() > most_name_bytes || !is_name_of_one_script(arguments.name))
    throw UsageError(
        "NAME", "is too long or can be mistaken for another name",
        fmt::format("give up to {} letters, digits and single spaces of one script", most_name_bytes));
  const std::unique_ptr<SqliteRecords> records = open_records(arguments.data);
  for (const Account& account : records->accounts()) {
    if (account.name != arguments.name && look_alike(account.name, arguments.name))
      throw Error(printable(arguments.name), "looks like the account " + printable(account.name),
                  "give a name that cannot be confused with it");
  }
  const PersonRole role = role_of(arguments, *records);
  records->set_account({arguments.name, role, hash_password(read_password("Password: "))});
  print("{} may sign in as {}\n", arguments.name, name_of(role));
}

void remove_account(const AccountArguments& arguments) {
  if (!open_records(arguments.data)->remove_account(arguments.name))
    throw Error(printable(arguments.name), "is not an account", "see rva account list");
  print("{} may no longer sign in\n", arguments.name);
}

void list_accounts(const AccountArguments& arguments) {
  for (const Account& account : open_records(arguments.data)->accounts())
    print("{:10} {}\n", name_of(account.role), account.name);
}

void add_data_flag(CLI::App& command, AccountArguments& arguments) {
  add_data_folder(command, arguments.data);
}

}  // namespace

void add_account_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("account", "manages the accounts of the console");
  command.require_subcommand(1);
  const auto arguments = std::make_shared<AccountArguments>();

  CLI::App& add = *command.add_subcommand(
      "add", "adds an account, or changes its role and password; asks for the password");
  add.add_option("NAME", arguments->name, "name of the person")->required();
  add.add_option(
         "--role", arguments->role,
         "viewer (looks), operator (drives, captures), inspector (decides); by default viewer for a new "
         "account, unchanged for an existing one")
      ->check(name_among<PersonRole>());
  add_data_flag(add, *arguments);
  add.callback([arguments] { add_account(*arguments); });

  CLI::App& remove = *command.add_subcommand("remove", "removes an account");
  remove.add_option("NAME", arguments->name, "name of the person")->required();
  add_data_flag(remove, *arguments);
  remove.callback([arguments] { remove_account(*arguments); });

  CLI::App& list = *command.add_subcommand("list", "lists all accounts");
  add_data_flag(list, *arguments);
  list.callback([arguments] { list_accounts(*arguments); });
}

}  // namespace rva::cli
