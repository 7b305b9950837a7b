#include "audit/signed_note.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr std::string_view dash = "\u2014 ";
constexpr std::size_t id_bytes = 4;
constexpr std::size_t most_signatures = 100;
constexpr std::size_t most_note_bytes = std::size_t{1} << 20U;

bool is_control_character(char character) {
  return static_cast<unsigned char>(character) < 0x20 && character != '\n';
}

std::optional<NoteSignature> signature_from(std::string_view line) {
  if (!line.starts_with(dash)) return std::nullopt;
  line.remove_prefix(dash.size());
  const std::size_t space = line.find(' ');
  if (space == line.npos) return std::nullopt;
  NoteSignature signature;
  signature.name = line.substr(0, space);
  const std::optional<std::string> bytes = bytes_from_base64(line.substr(space + 1));
  if (!is_key_name(signature.name) || !bytes || bytes->size() <= id_bytes) return std::nullopt;
  for (const char byte : bytes->substr(0, id_bytes))
    signature.id = signature.id << 8U | static_cast<unsigned char>(byte);
  signature.bytes = bytes->substr(id_bytes);
  return signature;
}

std::string line_of(const NoteSignature& signature) {
  std::string bytes;
  for (unsigned shift = 32; shift > 0; shift -= 8)
    bytes += static_cast<char>(static_cast<unsigned char>(signature.id >> (shift - 8)));
  return std::string(dash) + signature.name + ' ' + base64_of(bytes + signature.bytes) + '\n';
}

std::optional<SignedNote> parsed(std::string_view bytes) {
  if (bytes.size() > most_note_bytes || !is_utf8(bytes) ||
      std::any_of(bytes.begin(), bytes.end(), is_control_character))
    return std::nullopt;
  const std::size_t end = bytes.rfind("\n\n");
  if (end == bytes.npos || bytes.size() == end + 2 || !bytes.ends_with('\n')) return std::nullopt;
  SignedNote note{std::string(bytes.substr(0, end + 1)), {}};
  for (std::string_view left = bytes.substr(end + 2); !left.empty();) {
    const std::size_t line_end = left.find('\n');
    std::optional<NoteSignature> signature = signature_from(left.substr(0, line_end));
    if (!signature || note.signatures.size() == most_signatures) return std::nullopt;
    note.signatures.push_back(*std::move(signature));
    left.remove_prefix(line_end + 1);
  }
  return note;
}

}  // namespace

SignedNote parse_note(std::string_view bytes, const std::string& source) {
  if (std::optional<SignedNote> note = parsed(bytes)) return *std::move(note);
  throw Error(source, "is not a signed note, or it is damaged", "get the file again");
}

std::string text_of(const SignedNote& note) {
  std::string text = note.text + '\n';
  for (const NoteSignature& signature : note.signatures) text += line_of(signature);
  return text;
}

void sign(SignedNote& note, const SigningKey& key) {
  const Signature signature = key.sign(note.text);
  note.signatures.push_back(
      {key.public_key().name, key_id(key.public_key()), std::string(bytes_of(signature))});
}

std::vector<PublicKey> signers_of(const SignedNote& note, std::span<const PublicKey> keys,
                                  const std::string& source) {
  std::vector<PublicKey> signers;
  for (const PublicKey& key : keys) {
    bool signed_by_key = false;
    for (const NoteSignature& signature : note.signatures) {
      if (signature.name != key.name || signature.id != key_id(key)) continue;
      if (!is_signature(signature.bytes, note.text, key))
        throw Error(source, "is not what " + printable(name_with_id(key)) + " signed",
                    "get the file again; it was changed");
      signed_by_key = true;
    }
    if (signed_by_key) signers.push_back(key);
  }
  return signers;
}

}  // namespace rva
