#include "audit/known_log.hpp"

#include <fmt/format.h>

#include <optional>

#include "audit/site_log.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* ask_site = "ask the site for an explanation, and do not rely on the package";

// The log at an earlier size has to have had this root.
void require_prefix(const Checkpoint& checkpoint, const SiteLog& log, const fs::path& folder,
                    const std::string& source) {
  const std::uint64_t size = checkpoint.tree.size;
  if (size > log.leaves.size())
    throw Error(source,
                fmt::format("was signed when the log had {} records, but {} has {}", size, printable(folder),
                            log.leaves.size()),
                "get the site's present log; if this is it, records were taken back");
  if (tree_root(std::span(log.leaves).first(size)) != checkpoint.tree.root)
    throw Error(source, "is of a log with other records than " + printable(folder), ask_site);
}

// A checkpoint alone, or the one at the end of a log proof.
Checkpoint read_checkpoint(const fs::path& file, const PublicKey& key) {
  const std::string text = read_text_file(file);
  const bool is_proof = text.starts_with("c2sp.org/tlog-proof");
  return open_checkpoint(is_proof ? parse_log_proof(text, printable(file)).checkpoint : text, key,
                         printable(file));
}

void require_same(const Checkpoint& checkpoint, const Checkpoint& earlier, const std::string& source,
                  const fs::path& file) {
  if (checkpoint.tree.size != earlier.tree.size)
    throw Error(printable(file),
                "is of another size of the log, so that it cannot be compared without the log",
                "give a copy of the site's log, too");
  if (checkpoint.tree.root != earlier.tree.root)
    throw Error(source, "is of a log with other records than that of " + printable(file), ask_site);
}

}  // namespace

void require_in_known_log(const Checkpoint& checkpoint, const PublicKey& key, const std::string& source,
                          const KnownFromElsewhere& known) {
  std::optional<Checkpoint> earlier;
  if (known.checkpoint) earlier = read_checkpoint(*known.checkpoint, key);
  if (known.log) {
    const SiteLog log = read_log(*known.log, key);
    require_prefix(checkpoint, log, *known.log, source);
    if (earlier) require_prefix(*earlier, log, *known.log, printable(*known.checkpoint));
  } else if (earlier) {
    require_same(checkpoint, *earlier, source, *known.checkpoint);
  }
}

}  // namespace rva
