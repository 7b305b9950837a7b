#include "audit/envelope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "audit/digest.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The test vector of DSSE 1.0.2, protocol.md: the signature is one of ECDSA.
const std::string published =
    R"({"payload": "aGVsbG8gd29ybGQ=",
 "payloadType": "http://example.com/HelloWorld",
 "signatures": [{"sig": "A3JqsQGtVsJ2O2xqrI5IcnXip5GToJ3F+FnZ+O88SjtR6rDAajabZKciJTfUiHqJPcIAriEGAHTVeCUjW2JIZA=="}]})";

TEST(Envelope, EncodesAsTheSpecification) {
  EXPECT_EQ(pre_authentication_encoding("http://example.com/HelloWorld", "hello world"),
            "DSSEv1 29 http://example.com/HelloWorld 11 hello world");
  EXPECT_EQ(pre_authentication_encoding("", ""), "DSSEv1 0  0 ");
  EXPECT_EQ(pre_authentication_encoding("\u00fc", std::string("\0 1", 3)),
            std::string("DSSEv1 2 \u00fc 3 \0 1", 17));
}

TEST(Envelope, OfTheSpecificationIsRead) {
  const Envelope envelope = parse_envelope(published, "envelope");
  EXPECT_EQ(envelope.payload_type, "http://example.com/HelloWorld");
  EXPECT_EQ(envelope.payload, "hello world");
  ASSERT_EQ(envelope.signatures.size(), 1U);
  EXPECT_EQ(envelope.signatures[0].bytes.size(), 64U);
  EXPECT_EQ(envelope.signatures[0].key, "");
}

TEST(Envelope, StatesWhoSignedWhateverTheHintsAre) {
  const SigningKey ann = SigningKey::generate("ann");
  const SigningKey bob = SigningKey::generate("bob");
  Envelope envelope{"type", std::string("\0\xff", 2), {}};
  EXPECT_THAT(signers_of(envelope, {&ann.public_key(), 1}), IsEmpty());
  sign(envelope, ann);
  sign(envelope, bob);
  const std::vector<PublicKey> keys{bob.public_key(), SigningKey::generate("eve").public_key(),
                                    ann.public_key()};
  Envelope read = parse_envelope(text_of(envelope), "envelope");
  EXPECT_EQ(read.payload, envelope.payload);
  EXPECT_EQ(read.signatures, envelope.signatures);
  std::swap(read.signatures[0].key, read.signatures[1].key);
  EXPECT_THAT(signers_of(read, keys), ElementsAre(bob.public_key(), ann.public_key()));
  read.payload_type = "typ";
  EXPECT_THAT(signers_of(read, keys), IsEmpty());
  read.payload_type = "type";
  read.payload += ' ';
  EXPECT_THAT(signers_of(read, keys), IsEmpty());
}

TEST(Envelope, BoundaryOfTypeAndPayloadIsSigned) {
  const SigningKey ann = SigningKey::generate("ann");
  Envelope envelope{"ab", "c", {}};
  sign(envelope, ann);
  Envelope moved{"a", "bc", envelope.signatures};
  EXPECT_THAT(signers_of(moved, {&ann.public_key(), 1}), IsEmpty());
}

TEST(Envelope, OfUrlSafeBase64AndWithMoreFieldsIsRead) {
  const Envelope envelope = parse_envelope(
      R"({"payload":"-_8=","payloadType":"","extra":1,"signatures":[{"keyid":null,"sig":"","more":2}]})",
      "envelope");
  EXPECT_EQ(envelope.payload, "\xfb\xff");
}

TEST(Envelope, EveryOtherTextIsRefused) {
  for (const char* const text :
       {"", "{}", "[]", "null", R"({"payload":"","payloadType":""})",
        R"({"payload":"*","payloadType":"","signatures":[]})",
        R"({"payload":1,"payloadType":"","signatures":[]})",
        R"({"payload":"","payloadType":"","signatures":{}})",
        R"({"payload":"","payloadType":"","signatures":[1]})",
        R"({"payload":"","payloadType":"","signatures":[{}]})",
        R"({"payload":"","payloadType":"","signatures":[{"sig":"*"}]})", R"({"payload":"","signatures":[]})",
        R"({"payload":"aGVsbG8gd29ybGQ","payloadType":"","signatures":[]})"})
    EXPECT_THROW(static_cast<void>(parse_envelope(text, "envelope")), Error) << text;
  for (std::size_t size = 0; size < published.size(); ++size)
    EXPECT_THROW(static_cast<void>(parse_envelope(published.substr(0, size), "envelope")), Error) << size;
}

}  // namespace
}  // namespace rva
