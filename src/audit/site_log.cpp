#include "audit/site_log.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/folder_lock.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr std::size_t line_bytes = 65;
constexpr const char* use_backup = "restore the log from a backup; do not make a new one";

fs::path leaves_file(const fs::path& folder) { return folder / "leaves.txt"; }
fs::path checkpoint_file(const fs::path& folder) { return folder / "checkpoint"; }

std::string line_of(const Digest& leaf) { return hex_of(bytes_of(leaf)) + '\n'; }

std::vector<Digest> read_leaves(const fs::path& folder, std::uint64_t count) {
  if (count == 0) return {};
  const fs::path file = leaves_file(folder);
  const std::vector<std::byte> bytes = read_file(file);
  if (bytes.size() / line_bytes < count)
    throw Error(printable(file), "lacks records that were in the log when its checkpoint was signed",
                use_backup);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<Digest> leaves;
  leaves.reserve(count);
  for (std::size_t at = 0; leaves.size() < count; at += line_bytes) {
    const std::optional<Digest> leaf = digest_from_hex(text.substr(at, line_bytes - 1));
    if (!leaf || text[at + line_bytes - 1] != '\n')
      throw Error(printable(file), "is damaged in line " + std::to_string(leaves.size() + 1), use_backup);
    leaves.push_back(*leaf);
  }
  return leaves;
}

SiteLog log_of(const fs::path& folder, std::string note, const PublicKey& key) {
  SiteLog log;
  log.checkpoint = open_checkpoint(note, key, printable(checkpoint_file(folder)));
  log.note = std::move(note);
  log.leaves = read_leaves(folder, log.checkpoint.tree.size);
  if (tree_root(log.leaves) != log.checkpoint.tree.root)
    throw Error(printable(leaves_file(folder)), "is not the log whose checkpoint was signed", use_backup);
  return log;
}

// The checkpoint of an empty log is written before its first record, so that a lost checkpoint is noticed.
void begin_log(const fs::path& folder, const SigningKey& key) {
  std::error_code ignored;
  if (fs::exists(leaves_file(folder), ignored))
    throw Error(printable(checkpoint_file(folder)), "is missing", use_backup);
  replace_file(checkpoint_file(folder), signed_checkpoint({0, tree_root({})}, key));
}

// Removes what a program that was stopped has appended without signing it.
void remove_unsigned(const fs::path& folder, std::size_t count) {
  std::error_code failure;
  const fs::path file = leaves_file(folder);
  if (fs::exists(file, failure)) fs::resize_file(file, count * line_bytes, failure);
  if (failure)
    throw Error(printable(file), "cannot be written (" + failure.message() + ")", "check its permissions");
}

}  // namespace

bool is_log(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(checkpoint_file(folder), ignored) || fs::exists(leaves_file(folder), ignored);
}

SiteLog read_log(const fs::path& folder, const PublicKey& key) {
  return log_of(folder, read_text_file(checkpoint_file(folder)), key);
}

LogProof append_to_log(const fs::path& folder, const Digest& leaf, const SigningKey& key) {
  make_folders(folder);
  const FolderLock lock(folder);
  std::error_code ignored;
  if (!fs::exists(checkpoint_file(folder), ignored)) begin_log(folder, key);
  SiteLog log = read_log(folder, key.public_key());
  const std::size_t index = log.leaves.size();
  remove_unsigned(folder, index);
  append_to_file(leaves_file(folder), line_of(leaf));
  sync_tree(folder);
  log.leaves.push_back(leaf);
  log.note = signed_checkpoint({log.leaves.size(), tree_root(log.leaves)}, key);
  LogProof proof{index, inclusion_proof(log.leaves, index), log.note};
  replace_file(checkpoint_file(folder), log.note);
  return proof;
}

}  // namespace rva
