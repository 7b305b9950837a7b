// Checks a signed package of an inspection, without the records that it was made from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "audit/signing_key.hpp"
#include "audit/statement.hpp"
#include "audit/time_stamp.hpp"

namespace rva {

/// What the person who checks a package has from elsewhere. What is left out is not checked.
struct KnownFromElsewhere {
  /// The only keys that may have signed: those of the signers and of the log. Empty: those in the package.
  std::vector<PublicKey> keys;
  /// A copy of the site's log, in which the package's checkpoint must be found.
  std::optional<std::filesystem::path> log;
  /// An earlier checkpoint of the log, or the log proof of another package: the log must still contain it.
  std::optional<std::filesystem::path> checkpoint;
  /// A PEM file with the CAs of time stamp authorities: the package has to have a time stamp of one of them.
  std::optional<std::filesystem::path> time_stamp_ca{};
};

/// What was found in a package in which nothing is wrong.
struct CheckedPackage {
  Statement statement;                    ///< what was signed
  std::vector<PublicKey> signers;         ///< by whom, in the order of the signatures
  PublicKey log_key;                      ///< of the log that has the record
  std::uint64_t index = 0;                ///< of the record in the log, from 0
  std::uint64_t log_size = 0;             ///< records in the log when it was signed
  std::size_t files = 0;                  ///< in the payload
  std::uintmax_t bytes = 0;               ///< of the payload
  std::optional<TimeStamp> time_stamp{};  ///< of what was signed, if the package has one
};

/// Checks that a package is as it was signed. Every byte of every file is determined by what was signed, by
/// the signatures, or by the log: no change of any file is accepted, and neither is one more file or one
/// less.
/// @throws Error stating the first thing that is wrong; when a file that is given cannot be read; Interrupted
[[nodiscard]] CheckedPackage check_package(const std::filesystem::path& package,
                                           const KnownFromElsewhere& known);

}  // namespace rva
