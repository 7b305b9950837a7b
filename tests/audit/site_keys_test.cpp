#include "audit/site_keys.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr PasswordCost cheap{1, std::size_t{8} << 10U};
constexpr const char* password = "correct horse";

class SiteKeysTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path keys_folder_ = folder_ / "keys";
  SiteKeys keys_{keys_folder_, cheap};
};

TEST_F(SiteKeysTest, APersonKeepsTheKeyUntilThePasswordChanges) {
  const PublicKey first = keys_.key_of("Ida Weber", password).public_key();
  EXPECT_EQ(first.name, "Ida_Weber");
  EXPECT_EQ(keys_.key_of("Ida Weber", password).public_key(), first);
  const PublicKey second = keys_.key_of("Ida Weber", "battery staple").public_key();
  EXPECT_NE(second, first);
  EXPECT_EQ(keys_.key_of("Ida Weber", "battery staple").public_key(), second);
  EXPECT_EQ(keys_.public_keys(), (std::vector{first, second}));
}

TEST_F(SiteKeysTest, AnotherProgramFindsTheSameKeys) {
  const PublicKey log = keys_.log_key().public_key();
  const PublicKey person = keys_.key_of("Ann", password).public_key();
  SiteKeys others(keys_folder_, cheap);
  EXPECT_EQ(others.log_key().public_key(), log);
  EXPECT_EQ(others.key_of("Ann", password).public_key(), person);
  EXPECT_EQ(others.public_keys(), (std::vector{log, person}));
}

// Names that differ in characters that a file's name leaves out, and names that are no file's name at all.
TEST_F(SiteKeysTest, EveryPersonHasAKeyOfTheirOwn) {
  const std::vector<std::string> people{
      "Ann", "ann", "Änn", "Ånn", "../../Ann", "Ann Lee", "Ann\xE2\x80\x99s", "A+B", std::string(100, 'x')};
  std::vector<PublicKey> made;
  for (const std::string& person : people) made.push_back(keys_.key_of(person, password).public_key());
  for (std::size_t k = 0; k < people.size(); ++k)
    EXPECT_EQ(keys_.key_of(people[k], password).public_key(), made[k]) << people[k];
  EXPECT_EQ(keys_.public_keys().size(), people.size());
  EXPECT_FALSE(fs::exists(folder_ / "Ann"));
}

TEST_F(SiteKeysTest, NobodyElseReadsAPrivateKey) {
  static_cast<void>(keys_.log_key());
  static_cast<void>(keys_.key_of("Ann", password));
  std::size_t keys = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(keys_folder_)) {
    if (entry.path().extension() != ".key") continue;
    struct stat status {};
    ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U) << entry.path();
    ++keys;
  }
  EXPECT_EQ(keys, 2U);
}

TEST_F(SiteKeysTest, DamagedKeysAreReportedAndNotReplaced) {
  static_cast<void>(keys_.key_of("Ann", password));
  fs::path file;
  for (const fs::directory_entry& entry : fs::directory_iterator(keys_folder_ / "people"))
    if (entry.path().extension() == ".key") file = entry.path();
  std::string text = read_text_file(file);
  text.at(text.size() / 2) ^= 1;
  write_file(file, text);
  EXPECT_THROW(static_cast<void>(keys_.key_of("Ann", password)), Error);
  EXPECT_THROW(static_cast<void>(keys_.public_keys()), Error);
  EXPECT_EQ(read_text_file(file), text);
  EXPECT_NO_THROW(static_cast<void>(keys_.key_of("Bob", password)));
}

TEST_F(SiteKeysTest, WhatAKilledProgramLeftIsPutInOrder) {
  const PublicKey ann = keys_.key_of("Ann", password).public_key();
  const PublicKey log = keys_.log_key().public_key();
  for (const char* const left :
       {"log.key.partial-17", "log.key.pub.partial-17", "people/Bob-1.key.partial-3"})
    write_file(keys_folder_ / left, "half");
  fs::remove(keys_folder_ / "log.key.pub");
  EXPECT_EQ(keys_.repair().size(), 4U);
  EXPECT_EQ(keys_.repair().size(), 0U);
  EXPECT_EQ(read_public_key(keys_folder_ / "log.key.pub"), log);
  EXPECT_EQ(keys_.public_keys(), (std::vector{log, ann}));
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(keys_folder_))
    files += entry.is_regular_file() ? 1U : 0U;
  EXPECT_EQ(files, 4U);
  EXPECT_TRUE(SiteKeys(folder_ / "none").repair().empty());
}

TEST_F(SiteKeysTest, AnEncryptedLogKeyIsRefused) {
  fs::create_directories(keys_folder_);
  write_key_files(keys_folder_ / "log.key", SigningKey::generate("site"), password, cheap);
  EXPECT_THROW(static_cast<void>(keys_.log_key()), Error);
}

TEST_F(SiteKeysTest, ASitesOwnLogKeyIsUsed) {
  fs::create_directories(keys_folder_);
  const SigningKey own = SigningKey::generate("example.com/log");
  write_key_files(keys_folder_ / "log.key", own, std::nullopt);
  EXPECT_EQ(keys_.log_key().public_key(), own.public_key());
}

}  // namespace
}  // namespace rva
