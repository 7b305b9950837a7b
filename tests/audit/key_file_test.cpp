#include "audit/key_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;

constexpr PasswordCost cheap{1, std::size_t{8} << 10U};

std::string no_password(const PublicKey&, const fs::path&) {
  ADD_FAILURE() << "a password was asked for";
  return {};
}

class KeyFileTest : public testing::Test {
 protected:
  // What is wrong, according to the message.
  [[nodiscard]] std::string problem(const fs::path& file,
                                    const std::string& password = "correct horse") const {
    try {
      static_cast<void>(read_signing_key(file, [&](const PublicKey&, const fs::path&) { return password; }));
    } catch (const Error& error) {
      return error.problem();
    }
    return "nothing";
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_ / "ann.key";
  SigningKey key_ = SigningKey::generate("example.com/ann");
};

TEST_F(KeyFileTest, EncryptedKeyIsReadWithItsPassword) {
  write_key_files(file_, key_, "correct horse", cheap);
  std::string asked;
  const SigningKey read = read_signing_key(file_, [&](const PublicKey& key, const fs::path&) {
    asked = key.name;
    return "correct horse";
  });
  EXPECT_EQ(asked, "example.com/ann");
  EXPECT_EQ(read.public_key(), key_.public_key());
  EXPECT_EQ(read.sign("message"), key_.sign("message"));
  EXPECT_EQ(read_public_key(file_), key_.public_key());
  EXPECT_EQ(read_public_key(public_file_of(file_)), key_.public_key());
}

TEST_F(KeyFileTest, PlainKeyIsReadWithoutAPassword) {
  write_key_files(file_, key_, std::nullopt);
  EXPECT_EQ(read_signing_key(file_, no_password).public_key(), key_.public_key());
}

TEST_F(KeyFileTest, NobodyElseMayReadThePrivateKey) {
  const ::mode_t before = ::umask(0);
  write_key_files(file_, key_, std::nullopt);
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(file_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(KeyFileTest, WrongPasswordDamageAndAPublicKeyAreDistinguished) {
  write_key_files(file_, key_, "correct horse", cheap);
  EXPECT_THAT(problem(file_, "wrong horse"), HasSubstr("password"));
  EXPECT_THAT(problem(public_file_of(file_)), HasSubstr("is a public key"));
  EXPECT_THAT(problem(folder_ / "none"), HasSubstr("no such file"));
  const std::string text = read_text_file(file_);
  constexpr std::size_t stride = 5;  // each file is synced to the disk, which takes its time
  for (std::size_t at = 0; at < text.size(); at += stride) {
    std::string changed = text;
    changed[at] ^= 1;
    write_file(folder_ / "damaged", changed);
    EXPECT_THAT(problem(folder_ / "damaged"), HasSubstr("damaged")) << changed;
    write_file(folder_ / "damaged", text.substr(0, at));
    EXPECT_THAT(problem(folder_ / "damaged"), HasSubstr("damaged")) << at;
  }
}

TEST_F(KeyFileTest, DamagedPublicKeyIsRefused) {
  write_key_files(file_, key_, std::nullopt);
  const std::string text = read_text_file(public_file_of(file_));
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    std::string changed = text;
    changed[at] ^= 1;
    write_file(folder_ / "damaged", changed);
    EXPECT_THROW(static_cast<void>(read_public_key(folder_ / "damaged")), Error) << changed;
  }
}

TEST_F(KeyFileTest, KeysAreNeverReplaced) {
  write_key_files(file_, key_, std::nullopt);
  EXPECT_THROW(write_key_files(file_, SigningKey::generate("bob"), std::nullopt), Error);
  EXPECT_EQ(read_public_key(file_), key_.public_key());
  fs::remove(file_);
  EXPECT_THROW(write_key_files(file_, key_, std::nullopt), Error);
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(KeyFileTest, PasswordsOfAWrongLengthLeaveNothing) {
  for (const std::size_t length : {0U, 7U, 257U})
    EXPECT_THROW(write_key_files(file_, key_, std::string(length, 'x'), cheap), Error);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  EXPECT_THROW(write_key_files(folder_ / "none" / "key", key_, std::nullopt), Error);
}

}  // namespace
}  // namespace rva
