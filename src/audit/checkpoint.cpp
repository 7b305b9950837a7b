#include "audit/checkpoint.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr std::string_view proof_heading = "c2sp.org/tlog-proof@v1\n";
constexpr std::string_view index_word = "index ";
constexpr std::size_t most_hashes = 64;  // of a tree whose size has 64 bits

/// Takes lines from the beginning of a text.
class Lines {
 public:
  explicit Lines(std::string_view text) : left_(text) {}

  // The next line without its end; empty where no complete line is left.
  [[nodiscard]] std::optional<std::string_view> next() {
    const std::size_t end = left_.find('\n');
    if (end == left_.npos) return std::nullopt;
    const std::string_view line = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return line;
  }
  [[nodiscard]] std::string_view left() const { return left_; }

 private:
  std::string_view left_;
};

// Decimal digits without leading zeros.
std::optional<std::uint64_t> number_from(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || fmt::to_string(number) != text) return std::nullopt;
  return number;
}

std::optional<Checkpoint> parsed_checkpoint(std::string_view text) {
  Lines lines(text);
  const auto origin = lines.next();
  const auto size = lines.next();
  const auto root = lines.next();
  if (!origin || origin->empty() || !size || !root) return std::nullopt;
  const auto number = number_from(*size);
  const auto digest = digest_from_base64(*root);
  if (!number || !digest) return std::nullopt;
  while (!lines.left().empty()) {
    const auto extension = lines.next();
    if (!extension || extension->empty()) return std::nullopt;
  }
  return Checkpoint{std::string(*origin), {*number, *digest}};
}

std::optional<LogProof> parsed_proof(std::string_view text) {
  if (!text.starts_with(proof_heading)) return std::nullopt;
  Lines lines(text.substr(proof_heading.size()));
  const auto heading = lines.next();
  if (!heading || !heading->starts_with(index_word)) return std::nullopt;
  const auto index = number_from(heading->substr(index_word.size()));
  if (!index) return std::nullopt;
  LogProof proof{*index, {}, {}};
  for (;;) {
    const auto line = lines.next();
    if (line && line->empty()) break;
    const auto digest = line ? digest_from_base64(*line) : std::nullopt;
    if (!digest || proof.path.size() == most_hashes) return std::nullopt;
    proof.path.push_back(*digest);
  }
  proof.checkpoint = lines.left();
  return proof;
}

}  // namespace

std::string text_of(const Checkpoint& checkpoint) {
  return fmt::format("{}\n{}\n{}\n", checkpoint.origin, checkpoint.tree.size,
                     base64_of(bytes_of(checkpoint.tree.root)));
}

Checkpoint parse_checkpoint(std::string_view note_text, const std::string& source) {
  if (std::optional<Checkpoint> checkpoint = parsed_checkpoint(note_text)) return *std::move(checkpoint);
  throw Error(source, "is not the checkpoint of a log", "get the file again");
}

Checkpoint open_checkpoint(std::string_view note_bytes, const PublicKey& key, const std::string& source) {
  const SignedNote note = parse_note(note_bytes, source);
  if (signers_of(note, {&key, 1}, source).empty())
    throw Error(source, "is not signed by the log's key " + printable(name_with_id(key)),
                "give the key and the checkpoint of the same log");
  Checkpoint checkpoint = parse_checkpoint(note.text, source);
  if (checkpoint.origin != key.name)
    throw Error(source,
                "is the checkpoint of another log, " + printable(checkpoint.origin) + ", not of " +
                    printable(key.name),
                "give the key and the checkpoint of the same log");
  return checkpoint;
}

std::string signed_checkpoint(const TreeHead& tree, const SigningKey& key) {
  SignedNote note{text_of(Checkpoint{key.public_key().name, tree}), {}};
  sign(note, key);
  return text_of(note);
}

std::string text_of(const LogProof& proof) {
  std::string text = fmt::format("{}{}{}\n", proof_heading, index_word, proof.index);
  for (const Digest& digest : proof.path) text += base64_of(bytes_of(digest)) + '\n';
  return text + '\n' + proof.checkpoint;
}

LogProof parse_log_proof(std::string_view text, const std::string& source) {
  if (std::optional<LogProof> proof = parsed_proof(text)) return *std::move(proof);
  throw Error(source, "is not the proof that a record is in a log, or it is damaged", "get the file again");
}

}  // namespace rva
