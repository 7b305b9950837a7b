// Signs an exported inspection and makes it a package.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "audit/signing_key.hpp"
#include "audit/statement.hpp"

namespace rva {

/// From where a package gets its time stamp.
struct TimeStamping {
  std::string server;  ///< its URL
  /// A time stamp of these bytes, as time_stamp_in() returns it. @throws Error when the server gives none
  std::function<std::string(std::string_view bytes)> stamp;
};

/// By whom a package is signed, and the log that gets its record.
struct PackageSigning {
  std::vector<SigningKey> signers;  ///< at least one
  SigningKey log_key;               ///< may be one of the signers
  std::filesystem::path log;        ///< folder of the site's log
  TimeStamping time_stamping{};     ///< without a server: none
};

/// Makes a folder with the payload in `data/` a package: writes its checksums and the signed statement,
/// appends the record to the log, and writes its proof. With a time stamp server, the package has its time
/// stamp; if the server gives none, the signed statement states why, and the package is written all the same.
/// For use within an OutputFolder: if this throws, the folder is incomplete.
/// @param folder  contains `data/` and nothing else
/// @param made_at ISO 8601 in UTC
/// @throws Error when the payload has a file that no package can contain, the log is damaged or of another
/// key
///         (append_to_log()), or the disk refuses; Interrupted
void seal_package(const std::filesystem::path& folder, const StatedInspection& inspection,
                  const std::string& made_at, const PackageSigning& signing);

}  // namespace rva
