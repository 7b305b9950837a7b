// The keys of a site, on its server: those of the people who sign there, each opened by its owner's password,
// and that of the site's log.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "audit/key_file.hpp"

namespace rva {

/// The name of the folder of SiteKeys in a data folder.
inline constexpr const char* site_keys_name = "keys";

/// A folder of key files. Keys are added, and never replaced or removed: what was signed with an earlier key
/// of a person stays verifiable. Every member may be called from any thread.
///   - `log.key`: of the site's log, not encrypted, since the program signs with it by itself;
///   - `people/Ida_Weber-1f0c9ab2-1.key`: the first key of Ida Weber, encrypted with her password; the digits
///     in the middle distinguish people whose names differ in characters that the file's name leaves out.
/// Beside each, with .pub, is the public key (write_key_files()).
class SiteKeys {
 public:
  /// @param folder need not exist
  /// @param cost   of a new key's encryption
  explicit SiteKeys(std::filesystem::path folder, const PasswordCost& cost = {});

  /// The key of the log; made where there is none.
  /// @throws Error when its file is damaged or encrypted, or the disk refuses
  [[nodiscard]] SigningKey log_key();

  /// The last key of a person. Where that person has none, or has changed the password since it was made, a
  /// new one is made.
  /// @param person   the name of the account; spaces and plus signs become `_` in the key's name
  /// @param password of the account, which the caller has verified
  /// @throws Error when the file of the last key is damaged, the password is too short or too long for a key,
  ///         or the disk refuses
  [[nodiscard]] SigningKey key_of(const std::string& person, const std::string& password);

  /// All public keys, earlier ones included: that of the log first, then those of people by file name.
  /// @throws Error when a file is damaged
  [[nodiscard]] std::vector<PublicKey> public_keys() const;

  /// Puts in order what a program left that was stopped while it made a key: removes files that are not
  /// complete, and writes a public half that is missing. Call this before anything else uses the folder.
  /// @return one sentence for the user for each file
  /// @throws Error when a key is damaged, or the disk refuses
  std::vector<std::string> repair();

  /// The file of the log's key in a folder of keys.
  [[nodiscard]] static std::filesystem::path log_key_file(const std::filesystem::path& folder) {
    return folder / "log.key";
  }

 private:
  std::filesystem::path folder_;
  PasswordCost cost_;
  mutable std::mutex mutex_;
};

}  // namespace rva
