#include "audit/signing_key.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "audit/digest.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

// golang.org/x/mod/sumdb/note: note_test.go.
constexpr const char* peter = "PeterNeumann+c74f20a3+ARpc2QcUPDhMQegwxbzhKqiBfsVkmqq/LDE4izWy10TW";

SigningKey::Seed seed_from(const std::string& hex) { return digest_from_hex(hex).value(); }

// RFC 8032, section 7.1, test 2.
TEST(SigningKey, SignsAsTheStandard) {
  const SigningKey key("key", seed_from("4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb"));
  EXPECT_EQ(hex_of(bytes_of(key.public_key().bytes)),
            "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c");
  EXPECT_EQ(hex_of(bytes_of(key.sign("\x72"))),
            "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da"
            "085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb00d291612bb0c00");
}

TEST(SigningKey, SignatureIsThatOfOneMessageAndOneKey) {
  const SigningKey key = SigningKey::generate("ann");
  const SigningKey other = SigningKey::generate("ann");
  EXPECT_NE(key.public_key(), other.public_key());
  Signature signature = key.sign("message");
  EXPECT_TRUE(is_signature(signature, "message", key.public_key()));
  EXPECT_TRUE(is_signature(bytes_of(signature), "message", key.public_key()));
  EXPECT_FALSE(is_signature(signature, "message", other.public_key()));
  EXPECT_FALSE(is_signature(signature, "massage", key.public_key()));
  EXPECT_FALSE(is_signature(bytes_of(signature).substr(1), "message", key.public_key()));
  for (std::size_t bit = 0; bit < 8 * signature.size(); ++bit) {
    signature[bit / 8] ^= static_cast<unsigned char>(1U << bit % 8);
    EXPECT_FALSE(is_signature(signature, "message", key.public_key())) << bit;
    signature[bit / 8] ^= static_cast<unsigned char>(1U << bit % 8);
  }
}

TEST(PublicKey, IsReadFromAVerifierKeyAndWritten) {
  const PublicKey key = public_key_from(peter, "source");
  EXPECT_EQ(key.name, "PeterNeumann");
  EXPECT_EQ(key_id(key), 0xc74f20a3U);
  EXPECT_EQ(name_with_id(key), "PeterNeumann+c74f20a3");
  EXPECT_EQ(verifier_key(key), peter);
  // The key of the example of note_test.go whose seed is zero.
  EXPECT_EQ(verifier_key(SigningKey("EnochRoot", {}).public_key()),
            "EnochRoot+af0cfe78+ATtqJ7zOtqQtYqOo0CpvDXNlMhV3HeJDpjrASKGLWdop");
}

TEST(PublicKey, EveryOtherTextIsRefused) {
  const std::string text = peter;
  for (std::size_t from = 0; from <= text.size(); ++from) {
    for (std::size_t size = 1; from + size <= text.size() && size < text.size(); ++size)
      EXPECT_THROW(static_cast<void>(public_key_from(text.substr(from, size), "source")), Error);
  }
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string changed = text;
    ++changed[at];
    EXPECT_THROW(static_cast<void>(public_key_from(changed, "source")), Error) << changed;
  }
  for (const char* const bad :
       {"PeterNeumann+cc469956+ARpc2QcUPDhMQegwxbzhKqiBfsVkmqq/LDE4izWy10TWBADKEY==",  // key of another
                                                                                       // length
        "PeterNeumann+173116ae+ZRpc2QcUPDhMQegwxbzhKqiBfsVkmqq/LDE4izWy10TW",          // unknown algorithm
        "", "+", "++", "a+b+c"})
    EXPECT_THROW(static_cast<void>(public_key_from(bad, "source")), Error) << bad;
}

TEST(PublicKey, NamesHaveNoSpacesPlusSignsAndControlCharacters) {
  for (const char* const name : {"ann", "example.com/ann", "J\u00fcrgen", "@", "-"})
    EXPECT_TRUE(is_key_name(name)) << name;
  const std::vector<std::string> others{"",
                                        "a b",
                                        "a+b",
                                        "a\nb",
                                        "a\u00a0b",
                                        "a\u3000",
                                        "\u2028a",
                                        "\xff",
                                        std::string("a\0b", 3),
                                        std::string(201, 'a')};
  for (const std::string& name : others) EXPECT_FALSE(is_key_name(name)) << name;
}

}  // namespace
}  // namespace rva
