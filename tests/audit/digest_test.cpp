#include "audit/digest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

// FIPS 180-4, example of one block.
constexpr const char* sha256_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Digest, IsThatOfTheStandard) { EXPECT_EQ(hex_of(bytes_of(sha256("abc"))), sha256_of_abc); }

TEST(Digest, OfAFileIsThatOfItsBytes) {
  const test::TemporaryFolder folder;
  constexpr std::size_t chunk_bytes = 1U << 20U;
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, chunk_bytes, chunk_bytes + 1}) {
    const std::string bytes(size, 'x');
    write_file(folder / "file", bytes);
    EXPECT_EQ(sha256_of_file(folder / "file"), sha256(bytes)) << size;
  }
  EXPECT_THROW(static_cast<void>(sha256_of_file(folder / "none")), Error);
  EXPECT_THROW(static_cast<void>(sha256_of_file(folder.path())), Error);
}

TEST(Digest, IsReadFromLowerCaseHexAlone) {
  EXPECT_EQ(digest_from_hex(sha256_of_abc), sha256("abc"));
  std::string upper = sha256_of_abc;
  upper[0] = 'B';
  const std::string lower = sha256_of_abc;
  const std::vector<std::string> others{"", upper, lower.substr(2), lower + "00", std::string(64, 'g')};
  for (const std::string& text : others) EXPECT_FALSE(digest_from_hex(text)) << text;
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  const std::pair<const char*, const char*> examples[] = {
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : examples) {
    EXPECT_EQ(base64_of(bytes), text);
    EXPECT_EQ(bytes_from_base64(text), bytes);
  }
}

TEST(Base64, HasOneTextForTheSameBytes) {
  for (const char* const text : {"Zg", "Zg=", "Zh==", "Zg==\n", "Z g=", "Zg==Zg==", "-_8=", "*", "===="})
    EXPECT_FALSE(bytes_from_base64(text)) << text;
  EXPECT_EQ(bytes_from_either_base64("-_8="), "\xfb\xff");
  EXPECT_EQ(bytes_from_either_base64("+/8="), "\xfb\xff");
  EXPECT_FALSE(bytes_from_either_base64("+_8=?"));
  EXPECT_FALSE(digest_from_base64("Zg=="));
  EXPECT_EQ(digest_from_base64(base64_of(bytes_of(sha256("abc")))), sha256("abc"));
}

}  // namespace
}  // namespace rva
