#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "audit/envelope.hpp"
#include "audit/package_check.hpp"
#include "audit/package_files.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/audit/sealed_package.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using test::Contents;
using testing::HasSubstr;

class PackageTest : public testing::Test {
 protected:
  // What is wrong with the package; "nothing" if nothing is.
  [[nodiscard]] std::string wrong(const KnownFromElsewhere& known) const {
    try {
      static_cast<void>(check_package(package_.path(), known));
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }
  [[nodiscard]] std::string wrong() const { return wrong(package_.known()); }
  [[nodiscard]] fs::path path(const char* file) const { return package_.path() / file; }
  void change(const char* file, const std::string& from, const std::string& to) const {
    std::string text = read_text_file(path(file));
    write_file(path(file), text.replace(text.find(from), from.size(), to));
  }
  // The tag manifest is written again to fit the change, as an attacker would.
  void cover() const {
    FileDigests tags;
    for (const std::string& file : files_in(package_.path()))
      if (!file.starts_with("data/") && file != package_file::tag_manifest)
        tags.emplace(file, sha256_of_file(package_.path() / file));
    write_file(path(package_file::tag_manifest), manifest_text(tags));
  }

  test::SealedPackage package_;
};

TEST_F(PackageTest, IsAsItWasSigned) {
  const CheckedPackage checked = check_package(package_.path(), package_.known());
  ASSERT_EQ(checked.signers.size(), 2U);
  EXPECT_EQ(checked.signers[0], package_.ann().public_key());
  EXPECT_EQ(checked.log_key, package_.log_key().public_key());
  EXPECT_EQ(checked.index, 2U);
  EXPECT_EQ(checked.log_size, 3U);
  EXPECT_EQ(checked.files, 4U);
  std::size_t bytes = 0;
  for (const auto& [file, text] : test::SealedPackage::payload()) bytes += text.size();
  EXPECT_EQ(checked.bytes, bytes);
  EXPECT_EQ(checked.statement.inspection.aircraft, "N1");
  EXPECT_EQ(wrong({}), "nothing");
}

TEST_F(PackageTest, IsABag) {
  EXPECT_EQ(read_text_file(path("bagit.txt")), "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n");
  EXPECT_THAT(read_text_file(path("bag-info.txt")), HasSubstr("Payload-Oxum: 54.4\n"));
  EXPECT_THAT(read_text_file(path("bag-info.txt")), HasSubstr("Bagging-Date: 2026-01-01\n"));
  EXPECT_THAT(read_text_file(path("manifest-sha256.txt")),
              HasSubstr("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  data/empty\n"));
}

TEST_F(PackageTest, EveryFileIsNeeded) {
  for (const auto& [file, text] : test::contents_of(package_.path())) {
    fs::remove(package_.path() / file);
    EXPECT_NE(wrong(), "nothing") << file;
    test::write_contents(package_.path(), {{file, text}});
  }
  EXPECT_EQ(wrong(), "nothing");
}

TEST_F(PackageTest, NothingMayBeAdded) {
  for (const char* const file : {"data/more", "more.txt", "signature/more", "data/initial/more"}) {
    write_file(path(file), "");
    cover();
    EXPECT_THAT(wrong(), HasSubstr("was added")) << file;
    fs::remove(path(file));
  }
  cover();
  fs::create_directory(path("data/folder"));
  EXPECT_THAT(wrong(), HasSubstr("empty folder"));
  fs::remove(path("data/folder"));
  write_file(path("data/a b"), "");
  EXPECT_THAT(wrong(), HasSubstr("name"));
}

TEST_F(PackageTest, LinksAreRefused) {
  const fs::path aside = package_.path().parent_path() / "aside";
  fs::rename(path("data/empty"), aside);
  fs::create_symlink(aside, path("data/empty"));
  EXPECT_THAT(wrong(), HasSubstr("symbolic link"));
  fs::remove(path("data/empty"));
  fs::rename(aside, path("data/empty"));
  fs::rename(path("signature"), aside);
  fs::create_directory_symlink(aside, path("signature"));
  EXPECT_THAT(wrong(), HasSubstr("symbolic link"));
}

TEST_F(PackageTest, ChangedFileIsNamed) {
  change("data/final/000/depth/000000.png", "after", "later");
  EXPECT_THAT(wrong(), HasSubstr("data/final/000/depth/000000.png: is not what was signed"));
}

TEST_F(PackageTest, CoveredChangesAreFound) {
  change("data/final/000/depth/000000.png", "after", "later");
  const Digest later = sha256_of_file(path("data/final/000/depth/000000.png"));
  const std::string before = hex_of(bytes_of(sha256("pixels after")));
  change("manifest-sha256.txt", before, hex_of(bytes_of(later)));
  cover();
  EXPECT_THAT(wrong(), HasSubstr("is not what was signed"));
}

TEST_F(PackageTest, SignaturesOfOthersAreFound) {
  const SigningKey eve = SigningKey::generate("example.com/eve");
  Envelope envelope = parse_envelope(read_text_file(path(package_file::envelope)), "envelope");
  sign(envelope, eve);
  write_file(path(package_file::envelope), text_of(envelope));
  cover();
  EXPECT_THAT(wrong({}), HasSubstr("one signature of each signer"));
  append_to_file(path(package_file::signers), verifier_key(eve.public_key()) + '\n');
  cover();
  EXPECT_THAT(wrong({}), HasSubstr("the people that the statement names"));
  EXPECT_THAT(wrong(), HasSubstr("example.com/eve"));
}

TEST_F(PackageTest, SignatureThatWasTakenAwayIsFound) {
  Envelope envelope = parse_envelope(read_text_file(path(package_file::envelope)), "envelope");
  envelope.signatures.pop_back();
  write_file(path(package_file::envelope), text_of(envelope));
  write_file(path(package_file::signers), verifier_key(package_.ann().public_key()) + '\n');
  cover();
  EXPECT_THAT(wrong(), HasSubstr("the people that the statement names"));
}

TEST_F(PackageTest, RecordInAnotherLogIsFound) {
  const SigningKey eve = SigningKey::generate("example.com/log");
  const Envelope envelope = parse_envelope(read_text_file(path(package_file::envelope)), "envelope");
  const Digest leaf = record_leaf(envelope.payload_type, envelope.payload);
  write_file(path(package_file::proof), text_of(append_to_log(package_.scratch(), leaf, eve)));
  write_file(path(package_file::log_key), verifier_key(eve.public_key()) + '\n');
  cover();
  EXPECT_THAT(wrong({}), HasSubstr("the log that the statement names"));
}

// The same name, but another key, with which everything is signed anew.
TEST_F(PackageTest, ReplacedKeyIsFoundWithTheKeyFromElsewhere) {
  const SigningKey eve = SigningKey::generate("example.com/ann");
  const Contents payload{{"data/inspection.json", "nothing was found"}};
  fs::remove_all(package_.path());
  package_.seal(package_.path(), payload, {{eve}, eve, package_.scratch()});
  EXPECT_EQ(wrong({}), "nothing");
  EXPECT_THAT(wrong(), HasSubstr("which is none of those given"));
}

TEST_F(PackageTest, RecordsThatWereTakenBackAreFound) {
  fs::remove_all(package_.log());
  append_to_log(package_.log(), leaf_hash("earlier"), package_.log_key());
  EXPECT_THAT(wrong(), HasSubstr("taken back"));
}

TEST_F(PackageTest, SplitViewIsFound) {
  fs::remove_all(package_.log());
  for (const char* const record : {"earlier", "another", "instead", "next"})
    append_to_log(package_.log(), leaf_hash(record), package_.log_key());
  EXPECT_THAT(wrong(), HasSubstr("other records"));
}

TEST_F(PackageTest, EarlierCheckpointIsCompared) {
  KnownFromElsewhere known = package_.known();
  known.checkpoint = package_.path() / package_file::proof;
  EXPECT_EQ(wrong(known), "nothing");
  append_to_log(package_.log(), leaf_hash("next"), package_.log_key());
  known.checkpoint = package_.log() / "checkpoint";
  EXPECT_EQ(wrong(known), "nothing");
  known.log = std::nullopt;
  EXPECT_THAT(wrong(known), HasSubstr("copy of the site's log"));
  write_file(package_.scratch(), signed_checkpoint({3, leaf_hash("other")}, package_.log_key()));
  known.checkpoint = package_.scratch();
  EXPECT_THAT(wrong(known), HasSubstr("other records"));
  known.log = package_.log();
  EXPECT_THAT(wrong(known), HasSubstr("other records"));
  known.checkpoint = package_.log() / "none";
  EXPECT_THAT(wrong(known), HasSubstr("no such file"));
}

TEST_F(PackageTest, OtherFoldersAreNoPackages) {
  const auto problem = [&](const fs::path& folder) {
    try {
      static_cast<void>(check_package(folder, {}));
    } catch (const Error& error) {
      return error.problem();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(problem(package_.scratch()), "is not a folder");
  EXPECT_EQ(problem(path("bagit.txt")), "is not a folder");
  EXPECT_EQ(problem(package_.log()), "is not a package of an inspection");
}

TEST(PackagePath, StaysInTheFolder) {
  for (const char* const good : {"a", "data/a", "data/000/a-b_c.PNG", "..a", "a..b/c"})
    EXPECT_TRUE(is_package_path(good)) << good;
  for (const char* const bad : {"", "/", "/a", "a/", "a//b", ".", "..", "../a", "a/../b", "a/./b", "a b",
                                "a\nb", "a\\b", "a%0Ab", "\u00e4"})
    EXPECT_FALSE(is_package_path(bad)) << bad;
}

TEST(PackageWriter, PayloadWithOtherNamesIsRefusedBeforeItIsInTheLog) {
  const test::SealedPackage package;
  EXPECT_THROW(package.seal(package.scratch(), {{"data/a b", ""}}, package.signing()), Error);
  EXPECT_EQ(read_log(package.log(), package.log_key().public_key()).leaves.size(), 3U);
}

}  // namespace
}  // namespace rva
