// A small signed package, its keys and its log, for tests.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "audit/package_check.hpp"
#include "audit/package_writer.hpp"
#include "audit/signing_key.hpp"
#include "audit/site_log.hpp"
#include "tests/temporary_folder.hpp"

namespace rva::test {

/// Files by their paths in a folder.
using Contents = std::map<std::string, std::string>;

/// All files in a folder.
Contents contents_of(const std::filesystem::path& folder);

/// Writes files, and their folders.
void write_contents(const std::filesystem::path& folder, const Contents& contents);

/// A package of two signers as the third record of a log.
class SealedPackage {
 public:
  SealedPackage();

  [[nodiscard]] const std::filesystem::path& path() const { return package_; }
  [[nodiscard]] const std::filesystem::path& log() const { return log_; }
  [[nodiscard]] const SigningKey& ann() const { return ann_; }
  [[nodiscard]] const SigningKey& log_key() const { return log_key_; }
  /// The keys and a copy of the log, as from elsewhere.
  [[nodiscard]] KnownFromElsewhere known() const;
  /// A folder that a test may use.
  [[nodiscard]] std::filesystem::path scratch() const { return folder_ / "scratch"; }
  /// Signs a payload as another package, as a record more in a log.
  void seal(const std::filesystem::path& package, const Contents& payload,
            const PackageSigning& signing) const;
  [[nodiscard]] PackageSigning signing() const { return {{ann_, bob_}, log_key_, log_}; }
  [[nodiscard]] static Contents payload();

 private:
  TemporaryFolder folder_;
  std::filesystem::path package_ = folder_ / "package";
  std::filesystem::path log_ = folder_ / "log";
  SigningKey ann_ = SigningKey::generate("example.com/ann");
  SigningKey bob_ = SigningKey::generate("example.com/bob");
  SigningKey log_key_ = SigningKey::generate("example.com/log");
};

}  // namespace rva::test
