#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "audit/key_file.hpp"
#include "audit/site_keys.hpp"
#include "cli/commands.hpp"
#include "cli/hidden_input.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct KeyArguments {
  std::string name;
  std::string file;
  std::string data;
  bool no_password = false;
};

// Names are printed and compared by people, so that they consist of characters that look like no others.
bool is_plain_name(const std::string& name) {
  const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_/@";
  return is_key_name(name) && name.find_first_not_of(allowed) == name.npos;
}

std::optional<std::string> new_password(const KeyArguments& arguments) {
  if (arguments.no_password) return std::nullopt;
  std::string password = read_password("Password of the new key: ");
  if (::isatty(STDIN_FILENO) == 1 && read_password("The same again: ") != password)
    throw Error("password", "was entered differently the second time", "start again");
  return password;
}

void create_key(const KeyArguments& arguments) {
  if (!is_plain_name(arguments.name))
    throw UsageError("NAME", "is no name of a key",
                     "give letters of ASCII, digits and . - _ / @, as in example.com/ann");
  const SigningKey key = SigningKey::generate(arguments.name);
  write_key_files(arguments.file, key, new_password(arguments));
  if (arguments.no_password)
    fmt::print(stderr, "rva: warning: {} has no password; anybody who can read it can sign with it\n",
               printable(arguments.file));
  print("{}\n{}\n", arguments.file, public_file_of(arguments.file).native());
}

void list_keys(const KeyArguments& arguments) {
  if (!fs::is_directory(arguments.data))
    throw Error(printable(arguments.data), "is not a folder", "give the data folder of rva serve");
  for (const PublicKey& key : SiteKeys(fs::path(arguments.data) / site_keys_name).public_keys())
    print("{}\n", verifier_key(key));
}

}  // namespace

void add_key_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("key", "makes the keys with which inspections are signed");
  command.require_subcommand(1);
  const auto arguments = std::make_shared<KeyArguments>();

  CLI::App& create = *command.add_subcommand(
      "create", "makes a key: FILE, which its owner keeps, and FILE.pub, which everybody may have");
  create.add_option("NAME", arguments->name, "name of the person or the site, as in example.com/ann")
      ->required();
  create.add_option("--out", arguments->file, "file of the private key")->required()->type_name("FILE");
  create.add_flag("--no-password", arguments->no_password,
                  "do not encrypt the private key, for programs that sign without a person");
  create.callback([arguments] { create_key(*arguments); });

  CLI::App& list = *command.add_subcommand(
      "list", "prints the public keys of a site: that of its log first, then those of people");
  add_data_folder(list, arguments->data);
  list.callback([arguments] { list_keys(*arguments); });

  CLI::App& show = *command.add_subcommand("public", "prints the public key of a key's file");
  show.add_option("FILE", arguments->file, "file of a private or public key")->required();
  show.callback([arguments] { print("{}\n", verifier_key(read_public_key(arguments->file))); });
}

}  // namespace rva::cli
