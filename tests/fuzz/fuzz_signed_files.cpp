// The files of signed packages: what is accepted has one text only, except envelopes and checkpoints, which
// may have more than is read.
#include "audit/checkpoint.hpp"
#include "audit/envelope.hpp"
#include "audit/signed_note.hpp"
#include "audit/signing_key.hpp"
#include "audit/statement.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using rva::load_or_refuse;
  using rva::require;
  const std::string text(data, data + size);
  if (const auto key = load_or_refuse([&] { return rva::public_key_from(text, "key"); }))
    require(verifier_key(*key) == text, "a key has one text");
  if (const auto note = load_or_refuse([&] { return rva::parse_note(text, "note"); })) {
    require(text_of(*note) == text, "a note has one text");
    static_cast<void>(load_or_refuse([&] { return rva::parse_checkpoint(note->text, "note"); }));
  }
  if (const auto checkpoint = load_or_refuse([&] { return rva::parse_checkpoint(text, "checkpoint"); }))
    require(text.starts_with(text_of(*checkpoint)), "a checkpoint begins with what was read");
  if (const auto proof = load_or_refuse([&] { return rva::parse_log_proof(text, "proof"); }))
    require(text_of(*proof) == text, "a proof has one text");
  if (const auto statement = load_or_refuse([&] { return rva::parse_statement(text, "statement"); }))
    require(text_of(*statement) == text, "a statement has one text");
  if (const auto envelope = load_or_refuse([&] { return rva::parse_envelope(text, "envelope"); })) {
    const rva::Envelope again = rva::parse_envelope(text_of(*envelope), "envelope");
    require(again.payload == envelope->payload && again.payload_type == envelope->payload_type &&
                again.signatures == envelope->signatures,
            "an envelope is read as it was written");
  }
  return 0;
}
