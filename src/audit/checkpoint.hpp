// Checkpoints: the signed size and root of a log (c2sp.org/tlog-checkpoint), and proofs that an entry is in
// it, which need no network (c2sp.org/tlog-proof).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "audit/merkle_tree.hpp"
#include "audit/signed_note.hpp"

namespace rva {

/// What a log states about itself.
struct Checkpoint {
  std::string origin;  ///< name of the log, here that of its key; one line, not empty
  TreeHead tree;       ///< its size and root
};

/// The text of a checkpoint's note, unsigned.
[[nodiscard]] std::string text_of(const Checkpoint& checkpoint);

/// Reads the text of a checkpoint's note. Extension lines are accepted and ignored.
/// @param source where it is from, for errors
/// @throws Error when it is not a checkpoint
[[nodiscard]] Checkpoint parse_checkpoint(std::string_view note_text, const std::string& source);

/// Reads a signed checkpoint and checks its signature.
/// @param key of the log, whose name is the checkpoint's origin
/// @throws Error when it is not a checkpoint, of another log, or not signed by this key
[[nodiscard]] Checkpoint open_checkpoint(std::string_view note, const PublicKey& key,
                                         const std::string& source);

/// A checkpoint as a signed note.
[[nodiscard]] std::string signed_checkpoint(const TreeHead& tree, const SigningKey& key);

/// A proof that an entry is in a log.
struct LogProof {
  std::uint64_t index = 0;   ///< of the entry in the log, from 0
  std::vector<Digest> path;  ///< inclusion_proof()
  std::string checkpoint;    ///< signed note, verbatim
};

/// The proof as text, `c2sp.org/tlog-proof@v1`, without extra data.
[[nodiscard]] std::string text_of(const LogProof& proof);

/// Reads text_of() a proof, and no other text. The checkpoint is not parsed.
/// @throws Error when it is not a proof
[[nodiscard]] LogProof parse_log_proof(std::string_view text, const std::string& source);

}  // namespace rva
