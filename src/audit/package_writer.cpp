#include "audit/package_writer.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <system_error>

#include "audit/checkpoint.hpp"
#include "audit/envelope.hpp"
#include "audit/package_files.hpp"
#include "audit/site_log.hpp"
#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

FileDigests digests_of(const fs::path& folder, const std::set<std::string>& files) {
  FileDigests digests;
  for (const std::string& file : files) {
    throw_if_interrupted();
    digests.emplace(file, sha256_of_file(folder / file));
  }
  return digests;
}

// Payload-Oxum is the number of bytes and of files of the payload (RFC 8493, section 2.2.2).
std::string information_text(const fs::path& folder, const StatedInspection& inspection,
                             const std::string& made_at, const std::set<std::string>& payload) {
  std::uintmax_t bytes = 0;
  for (const std::string& file : payload) bytes += fs::file_size(folder / file);
  return fmt::format("Bagging-Date: {}\nExternal-Identifier: inspection {}\nPayload-Oxum: {}.{}\n",
                     made_at.substr(0, made_at.find('T')), inspection.number, bytes, payload.size());
}

Envelope signed_statement(const Statement& statement, const std::vector<SigningKey>& signers) {
  Envelope envelope{statement_payload_type, text_of(statement), {}};
  for (const SigningKey& key : signers) sign(envelope, key);
  return envelope;
}

// The time stamp is of the signatures, so that what is signed when there is none is another statement.
Envelope stamped_statement(Statement statement, const PackageSigning& signing, std::string& time_stamp) {
  if (signing.time_stamping.server.empty()) return signed_statement(statement, signing.signers);
  statement.time_stamp = StatedTimeStamp{signing.time_stamping.server, ""};
  Envelope envelope = signed_statement(statement, signing.signers);
  try {
    time_stamp = signing.time_stamping.stamp(text_of(envelope));
    return envelope;
  } catch (const Error& error) {
    statement.time_stamp->failure = error.problem();
    return signed_statement(statement, signing.signers);
  }
}

std::vector<PublicKey> public_keys_of(const std::vector<SigningKey>& keys) {
  std::vector<PublicKey> public_keys;
  for (const SigningKey& key : keys) public_keys.push_back(key.public_key());
  return public_keys;
}

}  // namespace

void seal_package(const fs::path& folder, const StatedInspection& inspection, const std::string& made_at,
                  const PackageSigning& signing) {
  using namespace package_file;
  const std::set<std::string> content = files_in(folder);
  write_file(folder / declaration, bag_declaration);
  write_file(folder / information, information_text(folder, inspection, made_at, content));
  const std::vector<PublicKey> signer_keys = public_keys_of(signing.signers);
  const PublicKey& key_of_log = signing.log_key.public_key();
  const Statement statement{inspection, made_at, verifier_keys_of(signer_keys), verifier_key(key_of_log),
                            digests_of(folder, files_in(folder))};
  write_file(folder / manifest, manifest_text(payload_of(statement.subjects)));
  std::string time_stamp_of_envelope;
  const Envelope envelope_of_statement = stamped_statement(statement, signing, time_stamp_of_envelope);
  std::error_code ignored;  // write_file() reports the error
  fs::create_directories(folder / fs::path(envelope).parent_path(), ignored);
  write_file(folder / envelope, text_of(envelope_of_statement));
  if (!time_stamp_of_envelope.empty()) write_file(folder / time_stamp, time_stamp_of_envelope);
  write_file(folder / signers, key_lines(signer_keys));
  write_file(folder / log_key, key_lines({key_of_log}));
  sync_tree(folder);  // a full disk has to be noticed before the log has the record
  const Digest leaf = record_leaf(envelope_of_statement.payload_type, envelope_of_statement.payload);
  write_file(folder / proof, text_of(append_to_log(signing.log, leaf, signing.log_key)));
  std::set<std::string> tags = files_in(folder);
  for (const std::string& file : content) tags.erase(file);
  write_file(folder / tag_manifest, manifest_text(digests_of(folder, tags)));
}

}  // namespace rva
