// The files of a signed package of an inspection: a bag (BagIt, RFC 8493) whose payload is the exported
// inspection (docs/record.md).
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "audit/signing_key.hpp"
#include "audit/statement.hpp"

namespace rva {

/// Names in a package, relative to it.
namespace package_file {
inline constexpr const char* declaration = "bagit.txt";                   ///< that the folder is a bag
inline constexpr const char* information = "bag-info.txt";                ///< what it contains, for people
inline constexpr const char* manifest = "manifest-sha256.txt";            ///< checksums of the payload
inline constexpr const char* tag_manifest = "tagmanifest-sha256.txt";     ///< checksums of all other files
inline constexpr const char* envelope = "signature/statement.dsse.json";  ///< the signed statement
inline constexpr const char* signers = "signature/signers.pub";           ///< public keys, one a line
inline constexpr const char* log_key = "signature/log.pub";               ///< public key of the site's log
inline constexpr const char* proof = "signature/record.tlog-proof";       ///< that the log has the record
inline constexpr const char* time_stamp = "signature/statement.tst";  ///< of the envelope, if there is one
inline constexpr const char* payload = "data/";                       ///< what the payload's paths begin with
}  // namespace package_file

/// The content of bagit.txt.
inline constexpr std::string_view bag_declaration =
    "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n";

/// The files that a package contains whatever its payload is.
[[nodiscard]] std::vector<std::string> package_files();

/// All files in a folder and its subfolders.
/// @throws Error when the folder is missing or contains anything but files and folders with files, such as
///         symbolic links, or a name with characters other than letters, digits, `.`, `_` and `-` of ASCII
[[nodiscard]] std::set<std::string> files_in(const std::filesystem::path& folder);

/// Whether a path stays within its folder and has a name that files_in() accepts.
[[nodiscard]] bool is_package_path(std::string_view path);

/// A manifest as `sha256sum -c` reads it: a line for each file, in the order of the paths.
[[nodiscard]] std::string manifest_text(const FileDigests& files);

/// Those of a statement's files that belong to the payload.
[[nodiscard]] FileDigests payload_of(const FileDigests& subjects);

/// The verifier_key() of each.
[[nodiscard]] std::vector<std::string> verifier_keys_of(const std::vector<PublicKey>& keys);

/// Public keys as the lines of a file.
[[nodiscard]] std::string key_lines(const std::vector<PublicKey>& keys);

/// The leaf hash under which a site's log has a statement: that of what its signatures sign.
[[nodiscard]] Digest record_leaf(std::string_view payload_type, std::string_view payload);

}  // namespace rva
