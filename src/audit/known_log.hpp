// A package's checkpoint compared with what is known of the log from elsewhere: whether records were taken
// back, or different people were shown different logs.
#pragma once

#include <string>

#include "audit/checkpoint.hpp"
#include "audit/package_check.hpp"

namespace rva {

/// @param checkpoint of a package
/// @param key        of the log
/// @param source     where the package's checkpoint is, for errors
/// @throws Error when the log, the earlier checkpoint and the package's do not belong to one log that only
///         grew, or this cannot be checked without the log
void require_in_known_log(const Checkpoint& checkpoint, const PublicKey& key, const std::string& source,
                          const KnownFromElsewhere& known);

}  // namespace rva
