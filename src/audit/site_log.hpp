// The append-only log of a site: which records were signed, in which order. A folder of two text files, which
// a kill at any moment leaves readable:
//   - `leaves.txt`: the leaf hash of each record, 64 hexadecimal digits and a line feed;
//   - `checkpoint`: the number of records and the root of their Merkle tree, signed with the log's key.
// A record is in the log when the checkpoint counts it. What is in leaves.txt beyond that is of a program
// that was stopped; the next record takes its place.
#pragma once

#include <filesystem>
#include <vector>

#include "audit/checkpoint.hpp"

namespace rva {

/// The content of a log, of which the checkpoint's signature and root are right.
struct SiteLog {
  Checkpoint checkpoint;       ///< as signed
  std::string note;            ///< the checkpoint as a signed note
  std::vector<Digest> leaves;  ///< of the records, as many as the checkpoint counts
};

/// Whether a folder contains a log, be it damaged or not.
[[nodiscard]] bool is_log(const std::filesystem::path& folder);

/// @param key of the log
/// @throws Error when a file is missing or damaged, or the log is that of another key
[[nodiscard]] SiteLog read_log(const std::filesystem::path& folder, const PublicKey& key);

/// Appends a record and signs the new checkpoint; creates the log where there is none. Takes time and memory
/// in proportion to the number of records: some seconds and 200 MB for a million.
/// @return the proof that the record is in the log
/// @throws Error when the log is damaged, of another key, used by another program or cannot be written; the
///         record is then not in it
LogProof append_to_log(const std::filesystem::path& folder, const Digest& leaf, const SigningKey& key);

}  // namespace rva
