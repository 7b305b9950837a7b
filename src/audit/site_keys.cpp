#include "audit/site_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "audit/digest.hpp"
#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* log_key_name = "site-log";
constexpr std::size_t most_stem_characters = 40;

bool is_ascii_letter_or_digit(char character) {
  return (character >= '0' && character <= '9') || (character >= 'A' && character <= 'Z') ||
         (character >= 'a' && character <= 'z');
}

// Spaces and plus signs have a meaning in the lines of keys.
std::string key_name_of(std::string person) {
  std::ranges::replace(person, ' ', '_');
  std::ranges::replace(person, '+', '_');
  return person;
}

// The beginning of the names of a person's files.
std::string file_stem_of(const std::string& person) {
  std::string stem = person.substr(0, most_stem_characters);
  std::ranges::replace_if(
      stem, [](char character) { return !is_ascii_letter_or_digit(character); }, '_');
  return fmt::format("{}-{:.8}-", stem, hex_of(bytes_of(sha256(person))));
}

fs::path file_of(const fs::path& folder, const std::string& person, int number) {
  return folder / "people" / fmt::format("{}{}.key", file_stem_of(person), number);
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

SiteKeys::SiteKeys(fs::path folder, const PasswordCost& cost) : folder_(std::move(folder)), cost_(cost) {}

SigningKey SiteKeys::log_key() {
  const std::lock_guard lock(mutex_);
  const fs::path file = log_key_file(folder_);
  if (!is_there(file)) {
    make_folders(folder_);
    write_key_files(file, SigningKey::generate(log_key_name), std::nullopt);
  }
  return read_signing_key(file, [](const PublicKey& /*key*/, const fs::path& of) -> std::string {
    throw Error(printable(of), "is encrypted, so that the program cannot sign the log by itself",
                "put the log's key there without a password");
  });
}

SigningKey SiteKeys::key_of(const std::string& person, const std::string& password) {
  const std::lock_guard lock(mutex_);
  int number = 1;
  while (is_there(file_of(folder_, person, number))) ++number;
  try {
    if (number > 1)
      return read_signing_key(file_of(folder_, person, number - 1),
                              [&](const PublicKey& /*key*/, const fs::path& /*of*/) { return password; });
  } catch (const WrongKeyPassword&) {
    // The person has another password now, which opens none of the earlier keys.
  }
  SigningKey key = SigningKey::generate(key_name_of(person));
  make_folders(folder_ / "people");
  write_key_files(file_of(folder_, person, number), key, password, cost_);
  return key;
}

std::vector<PublicKey> SiteKeys::public_keys() const {
  const std::lock_guard lock(mutex_);
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "people", failure))
    if (entry.path().extension() == ".key") files.push_back(entry.path());
  std::ranges::sort(files);
  if (const fs::path log = log_key_file(folder_); is_there(log)) files.insert(files.begin(), log);
  std::vector<PublicKey> keys;
  for (const fs::path& file : files) keys.push_back(read_public_key(file));
  return keys;
}

}  // namespace rva
