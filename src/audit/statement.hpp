// The statement that a signature of an inspection makes: which files belong to it, with their SHA-256, as an
// in-toto Statement v1 (github.com/in-toto/attestation) with a predicate of RVA's own (docs/record.md).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "audit/digest.hpp"

namespace rva {

/// Files of a package by their paths, relative to it and with slashes.
using FileDigests = std::map<std::string, Digest>;

/// The payload type of an envelope around a statement.
inline constexpr const char* statement_payload_type = "application/vnd.in-toto+json";

/// The type of the predicate.
inline constexpr const char* inspection_predicate_type = "urn:rva:inspection-record:v1";

/// Which inspection a package is of, as its inspection.json has it.
struct StatedInspection {
  std::int64_t number = 0;  ///< in the records of the site
  std::string aircraft;     ///< UTF-8
  std::string zone;         ///< UTF-8
  std::string work_order;   ///< UTF-8
};

/// What a statement states of the time stamp that was asked for.
struct StatedTimeStamp {
  std::string server;   ///< the URL that was asked
  std::string failure;  ///< why there is no time stamp; empty: the package has it

  /// Whether the package has it.
  [[nodiscard]] bool is_there() const { return failure.empty(); }
};

/// What is signed.
struct Statement {
  StatedInspection inspection;                  ///< which inspection
  std::string made_at;                          ///< when the package was made, ISO 8601 in UTC
  std::vector<std::string> signers;             ///< verifier_key() of each, in the order of the signatures
  std::string log;                              ///< verifier_key() of the site's log that gets the record
  FileDigests subjects;                         ///< every file whose content no other file determines
  std::optional<StatedTimeStamp> time_stamp{};  ///< empty: none was asked for
};

/// The statement as JSON, in the one form that RVA writes.
[[nodiscard]] std::string text_of(const Statement& statement);

/// Reads text_of() a statement, and no other text: what two programs could read differently is refused.
/// @param source where it is from, for errors
/// @throws Error when it is not such a statement
[[nodiscard]] Statement parse_statement(const std::string& text, const std::string& source);

}  // namespace rva
