#include "audit/site_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "audit/digest.hpp"
#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "core/remains.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* log_key_name = "site-log";
constexpr const char* people_name = "people";
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
  return folder / people_name / fmt::format("{}{}.key", file_stem_of(person), number);
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

// In the order of their names.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
    if (entry.is_regular_file(failure)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

// Private keys: that of the log first, then those of people.
std::vector<fs::path> key_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (const fs::path log = SiteKeys::log_key_file(folder); is_there(log)) files.push_back(log);
  for (const fs::path& file : files_in(folder / people_name))
    if (file.extension() == ".key") files.push_back(file);
  return files;
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
  make_folders(folder_ / people_name);
  write_key_files(file_of(folder_, person, number), key, password, cost_);
  return key;
}

std::vector<PublicKey> SiteKeys::public_keys() const {
  const std::lock_guard lock(mutex_);
  std::vector<PublicKey> keys;
  for (const fs::path& file : key_files_in(folder_)) keys.push_back(read_public_key(file));
  return keys;
}

std::vector<std::string> SiteKeys::repair() {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> done;
  for (const fs::path& folder : {folder_, folder_ / people_name})
    for (const fs::path& file : files_in(folder)) {
      std::error_code failure;
      if (!is_name_of_remains(file) || !fs::remove(file, failure)) continue;
      done.push_back(printable(file) + ": removed: it was not complete when the program was stopped");
    }
  for (const fs::path& file : key_files_in(folder_)) {
    if (is_there(public_file_of(file))) continue;
    replace_file(public_file_of(file), verifier_key(read_public_key(file)) + '\n');
    done.push_back(printable(public_file_of(file)) + ": written from the private key beside it");
  }
  return done;
}

}  // namespace rva
