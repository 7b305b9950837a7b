#include "audit/package_check.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "audit/checkpoint.hpp"
#include "audit/envelope.hpp"
#include "audit/known_log.hpp"
#include "audit/package_files.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* get_again = "do not rely on this package; get it again";

/// A package whose files were listed.
class Package {
 public:
  explicit Package(fs::path folder) : folder_(std::move(folder)), files_(files_in(folder_)) {
    if (!files_.contains(package_file::declaration))
      throw Error(printable(folder_), "is not a package of an inspection", "check the path");
    for (const std::string& file : package_files())
      if (!files_.contains(file)) throw wrong(file, "is missing");
  }

  [[nodiscard]] const std::set<std::string>& files() const { return files_; }
  [[nodiscard]] fs::path path(const std::string& file) const { return folder_ / file; }
  [[nodiscard]] std::string name(const std::string& file) const { return printable(path(file)); }
  [[nodiscard]] Error wrong(const std::string& file, const std::string& problem) const {
    return {name(file), problem, get_again};
  }
  // Manifests and envelopes of many files are larger than read_text_file() accepts.
  [[nodiscard]] std::string text(const std::string& file) const {
    const std::vector<std::byte> bytes = read_file(path(file));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  void require_text(const std::string& file, std::string_view expected, const std::string& problem) const {
    if (text(file) != expected) throw wrong(file, problem);
  }

 private:
  fs::path folder_;
  std::set<std::string> files_;
};

std::vector<PublicKey> keys_in(const Package& package, const std::string& file) {
  const std::string text = package.text(file);
  std::vector<PublicKey> keys;
  for (std::string_view left = text; !left.empty();) {
    const std::size_t end = left.find('\n');
    if (end == left.npos) throw package.wrong(file, "was cut off");
    keys.push_back(public_key_from(left.substr(0, end), package.name(file)));
    left.remove_prefix(end + 1);
  }
  if (keys.empty()) throw package.wrong(file, "contains no key");
  return keys;
}

void require_known(const Package& package, const std::string& file, const std::vector<PublicKey>& keys,
                   const std::vector<PublicKey>& known) {
  for (const PublicKey& key : keys) {
    if (known.empty() || std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw package.wrong(file,
                        "names the key " + printable(name_with_id(key)) + ", which is none of those given");
  }
}

// Each signature has to be of the key in the same line of the file of signers: one more would be of somebody
// that nothing in the package names.
Envelope signed_envelope(const Package& package, const std::vector<PublicKey>& signers) {
  const std::string file = package_file::envelope;
  const std::string text = package.text(file);
  Envelope envelope = parse_envelope(text, package.name(file));
  if (envelope.signatures.size() != signers.size())
    throw package.wrong(file, "does not have one signature of each signer");
  for (std::size_t k = 0; k < signers.size(); ++k) {
    Envelope one = envelope;
    one.signatures = {envelope.signatures[k]};
    if (signers_of(one, {&signers[k], 1}).empty())
      throw package.wrong(file, "is not what " + printable(name_with_id(signers[k])) + " signed");
    if (envelope.signatures[k].key != name_with_id(signers[k]))
      throw package.wrong(file, "names another key than the one that signed");
  }
  if (envelope.payload_type != statement_payload_type)
    throw package.wrong(file, "contains no statement about files");
  if (text_of(envelope) != text) throw package.wrong(file, "is not laid out as rva writes it");
  return envelope;
}

// A signature that was taken away, and another log, would be noticed by nothing else.
void require_same_keys(const Package& package, const CheckedPackage& checked) {
  if (verifier_keys_of(checked.signers) != checked.statement.signers)
    throw package.wrong(package_file::signers, "does not name the people that the statement names");
  if (verifier_key(checked.log_key) != checked.statement.log)
    throw package.wrong(package_file::log_key, "is not the key of the log that the statement names");
}

void require_same_files(const Package& package, const Statement& statement) {
  const FileDigests& signed_files = statement.subjects;
  const std::vector<std::string> always = package_files();
  std::set<std::string> expected(always.begin(), always.end());
  for (const char* const file : {package_file::declaration, package_file::information})
    if (!signed_files.contains(file)) throw package.wrong(file, "was not signed");
  if (statement.time_stamp && statement.time_stamp->is_there()) {
    if (!package.files().contains(package_file::time_stamp))
      throw package.wrong(package_file::time_stamp, "is missing: there was a time stamp when it was signed");
    expected.insert(package_file::time_stamp);
  }
  for (const auto& [file, digest] : signed_files) {
    if (!package.files().contains(file)) throw package.wrong(file, "was signed and is missing");
    expected.insert(file);
  }
  for (const std::string& file : package.files())
    if (!expected.contains(file)) throw package.wrong(file, "was not signed: it was added");
}

void require_same_content(const Package& package, const FileDigests& signed_files) {
  for (const auto& [file, digest] : signed_files) {
    throw_if_interrupted();
    if (sha256_of_file(package.path(file)) != digest)
      throw package.wrong(file, "is not what was signed: it was changed");
  }
}

FileDigests tags_of(const Package& package, const FileDigests& payload) {
  FileDigests tags;
  for (const std::string& file : package.files())
    if (!payload.contains(file) && file != package_file::tag_manifest)
      tags.emplace(file, sha256_of_file(package.path(file)));
  return tags;
}

void require_manifests(const Package& package, const FileDigests& signed_files) {
  using namespace package_file;
  const FileDigests payload = payload_of(signed_files);
  package.require_text(declaration, bag_declaration, "is not that of BagIt 1.0");
  package.require_text(manifest, manifest_text(payload), "does not list the files that were signed");
  package.require_text(tag_manifest, manifest_text(tags_of(package, payload)),
                       "does not list the files of this package");
}

// Checks the record's proof and returns its checkpoint.
Checkpoint require_record(const Package& package, const Envelope& envelope, const PublicKey& log_key,
                          CheckedPackage& checked) {
  const std::string file = package_file::proof;
  const std::string text = package.text(file);
  const LogProof proof = parse_log_proof(text, package.name(file));
  Checkpoint checkpoint = open_checkpoint(proof.checkpoint, log_key, package.name(file));
  const Digest leaf = record_leaf(envelope.payload_type, envelope.payload);
  if (!is_included(leaf, proof.index, checkpoint.tree, proof.path))
    throw package.wrong(file, "does not prove that the log has this record");
  if (parse_note(proof.checkpoint, package.name(file)).signatures.size() != 1)
    throw package.wrong(file, "has more signatures than that of the log");
  checked.index = proof.index;
  checked.log_size = checkpoint.tree.size;
  return checkpoint;
}

// Why a package has no time stamp.
std::string reason_of(const std::optional<StatedTimeStamp>& stated) {
  return stated ? stated->server + ": " + stated->failure : std::string("no server was asked");
}

std::optional<TimeStamp> checked_time_stamp(const Package& package, const Statement& statement,
                                            const std::optional<fs::path>& trusted_ca) {
  const std::string file = package_file::time_stamp;
  if (statement.time_stamp && statement.time_stamp->is_there())
    return check_time_stamp(package.text(file), package.text(package_file::envelope), trusted_ca,
                            package.name(file));
  if (trusted_ca)
    throw Error(package.name(file), "does not exist (" + printable(reason_of(statement.time_stamp)) + ")",
                "ask the site for another proof of the time, or verify without a time stamp");
  return std::nullopt;
}

std::uintmax_t size_of(const Package& package, const FileDigests& payload) {
  std::uintmax_t bytes = 0;
  for (const auto& [file, digest] : payload) bytes += fs::file_size(package.path(file));
  return bytes;
}

}  // namespace

CheckedPackage check_package(const fs::path& folder, const KnownFromElsewhere& known) {
  const Package package(folder);
  CheckedPackage checked;
  checked.signers = keys_in(package, package_file::signers);
  const std::vector<PublicKey> log_keys = keys_in(package, package_file::log_key);
  if (log_keys.size() != 1) throw package.wrong(package_file::log_key, "contains more than one key");
  checked.log_key = log_keys.front();
  require_known(package, package_file::signers, checked.signers, known.keys);
  require_known(package, package_file::log_key, log_keys, known.keys);
  const Envelope envelope = signed_envelope(package, checked.signers);
  checked.statement = parse_statement(envelope.payload, package.name(package_file::envelope));
  require_same_keys(package, checked);
  const FileDigests& signed_files = checked.statement.subjects;
  require_same_files(package, checked.statement);
  require_same_content(package, signed_files);
  require_manifests(package, signed_files);
  checked.time_stamp = checked_time_stamp(package, checked.statement, known.time_stamp_ca);
  const Checkpoint checkpoint = require_record(package, envelope, checked.log_key, checked);
  require_in_known_log(checkpoint, checked.log_key, package.name(package_file::proof), known);
  const FileDigests payload = payload_of(signed_files);
  checked.files = payload.size();
  checked.bytes = size_of(package, payload);
  return checked;
}

}  // namespace rva
