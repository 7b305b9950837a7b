#include "audit/package_files.hpp"

#include <algorithm>
#include <system_error>

#include "audit/envelope.hpp"
#include "audit/merkle_tree.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* get_again = "get the package again";

bool is_allowed(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || character == '.' || character == '_' || character == '-';
}

bool is_allowed_name(std::string_view name) {
  return !name.empty() && name != "." && name != ".." && std::all_of(name.begin(), name.end(), is_allowed);
}

// What is wrong with an entry; null if nothing is.
const char* problem_of(const fs::directory_entry& entry, const fs::path& folder) {
  const fs::file_type type = entry.symlink_status().type();
  if (type == fs::file_type::symlink) return "is a symbolic link";
  if (type != fs::file_type::regular && type != fs::file_type::directory) return "is no file and no folder";
  if (!is_package_path(entry.path().lexically_relative(folder).native()))
    return "has a name that no file of a package has";
  if (type == fs::file_type::directory && fs::is_empty(entry.path())) return "is an empty folder";
  return nullptr;
}

}  // namespace

std::vector<std::string> package_files() {
  using namespace package_file;
  return {declaration, information, manifest, tag_manifest, envelope, signers, log_key, proof};
}

std::set<std::string> files_in(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw Error(printable(folder), "is not a folder", "check the path");
  std::set<std::string> files;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (const char* const problem = problem_of(entry, folder))
        throw Error(printable(entry.path()), problem, get_again);
      if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(folder).native());
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(printable(folder), "cannot be read (" + error.code().message() + ")",
                "check its permissions");
  }
  return files;
}

bool is_package_path(std::string_view path) {
  for (;;) {
    const std::size_t slash = path.find('/');
    if (!is_allowed_name(path.substr(0, slash))) return false;
    if (slash == path.npos) return true;
    path.remove_prefix(slash + 1);
  }
}

std::string manifest_text(const FileDigests& files) {
  std::string text;
  for (const auto& [path, digest] : files) text += hex_of(bytes_of(digest)) + "  " + path + '\n';
  return text;
}

FileDigests payload_of(const FileDigests& subjects) {
  FileDigests payload;
  for (const auto& [path, digest] : subjects)
    if (path.starts_with(package_file::payload)) payload.emplace(path, digest);
  return payload;
}

std::vector<std::string> verifier_keys_of(const std::vector<PublicKey>& keys) {
  std::vector<std::string> texts;
  for (const PublicKey& key : keys) texts.push_back(verifier_key(key));
  return texts;
}

std::string key_lines(const std::vector<PublicKey>& keys) {
  std::string lines;
  for (const std::string& key : verifier_keys_of(keys)) lines += key + '\n';
  return lines;
}

Digest record_leaf(std::string_view payload_type, std::string_view payload) {
  return leaf_hash(pre_authentication_encoding(payload_type, payload));
}

}  // namespace rva
