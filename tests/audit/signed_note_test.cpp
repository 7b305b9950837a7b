#include "audit/signed_note.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "audit/digest.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// golang.org/x/mod/sumdb/note: note_test.go.
constexpr const char* peter_key = "PeterNeumann+c74f20a3+ARpc2QcUPDhMQegwxbzhKqiBfsVkmqq/LDE4izWy10TW";
constexpr const char* enoch_key = "EnochRoot+af0cfe78+ATtqJ7zOtqQtYqOo0CpvDXNlMhV3HeJDpjrASKGLWdop";
constexpr const char* peter_private_key = "AYEKFALVFGyNhPJEMzD1QIDr+Y7hfZx09iUvxdXHKDFz";
const std::string text =
    "If you think cryptography is the answer to your problem,\n"
    "then you don't know what your problem is.\n";
const std::string peter_line =
    "\u2014 PeterNeumann "
    "x08go/ZJkuBS9UG/SffcvIAQxVBtiFupLLr8pAcElZInNIuGUgYN1FFYC2pZSNXgKvqfqdngotpRZb6KE6RyyBwJnAM=\n";
const std::string enoch_line =
    "\u2014 EnochRoot "
    "rwz+eBzmZa0SO3NbfRGzPCpDckykFXSdeX+MNtCOXm2/5n2tiOHp+vAF1aGrQ5ovTG01oOTGwnWLox33WWd1RvMc+QQ=\n";

PublicKey key(const char* verifier_key) { return public_key_from(verifier_key, "key"); }

std::vector<PublicKey> signers(const std::string& note, const std::vector<PublicKey>& keys) {
  return signers_of(parse_note(note, "note"), keys, "note");
}

TEST(SignedNote, IsThePublishedOne) {
  SigningKey::Seed seed{};
  const std::string typed = bytes_from_base64(peter_private_key).value();
  std::copy(typed.begin() + 1, typed.end(), seed.begin());
  SignedNote note{text, {}};
  sign(note, SigningKey("PeterNeumann", seed));
  EXPECT_EQ(text_of(note), text + '\n' + peter_line);
  sign(note, SigningKey("EnochRoot", {}));
  EXPECT_EQ(text_of(note), text + '\n' + peter_line + enoch_line);
}

TEST(SignedNote, StatesWhoSigned) {
  const std::string both = text + '\n' + peter_line + enoch_line;
  EXPECT_THAT(signers(both, {key(peter_key)}), ElementsAre(key(peter_key)));
  EXPECT_THAT(signers(both, {key(enoch_key), key(peter_key)}), ElementsAre(key(enoch_key), key(peter_key)));
  EXPECT_THAT(signers(text + '\n' + peter_line, {key(enoch_key)}), IsEmpty());
  EXPECT_THAT(signers(both, {}), IsEmpty());
}

// The examples of c2sp.org/signed-note.
TEST(SignedNote, OfTheSpecificationIsAccepted) {
  const PublicKey foo = key("example.com/foo+530d903a+AekyeRrm56hApGFkyQR4ZCbV54Id2LKaANYcrnKv3U2k");
  EXPECT_THAT(
      signers("This is an example message.\n\n\u2014 example.com/foo Uw2QOkn8srV1yJGh2VYRlL1Tnagv1YEq6TfX"
              "ppzi2ONncAlTgK7Ztg1ERYNZXsYjOBH3mFXmRKuwHjG1Yu72IneyaQM=\n",
              {foo}),
      ElementsAre(foo));
  const std::string poem =
      "Ognuno sta solo sul cuor della terra\ntrafitto da un raggio di sole:\n\ned \u00e8 subito sera.\n\n"
      "\u2014 quasimodo.example/salvatore "
      "NnugSzTjtVAewIS+Z/iJhUPeFDkO/5QQ2i5ddnGITLlC+EhfLW9oJKONrMouFSQU0xMcXxj99"
      "ihAQwaqP3ZekRwNtIc=\n";
  EXPECT_EQ(text_of(parse_note(poem, "poem")), poem);
}

TEST(SignedNote, WrongSignatureOfAKnownKeyIsAnErrorAndOfAnotherIsIgnored) {
  std::string changed = text + '\n' + peter_line;
  changed[0] = 'i';
  EXPECT_THROW(static_cast<void>(signers(changed, {key(peter_key)})), Error);
  EXPECT_THAT(signers(changed, {key(enoch_key)}), IsEmpty());
  // A good signature does not make up for a bad one of the same key.
  const std::string bad_line =
      "\u2014 PeterNeumann " + base64_of("\xc7\x4f\x20\xa3" + std::string(64, 'x')) + '\n';
  EXPECT_THROW(static_cast<void>(signers(text + '\n' + peter_line + bad_line, {key(peter_key)})), Error);
}

TEST(SignedNote, EveryOtherTextIsRefused) {
  const std::string line = peter_line;
  std::vector<std::string> bad{"",
                               "\n",
                               text,
                               text + peter_line,
                               text + '\n',
                               text + '\n' + text,
                               text + '\n' + peter_line + '\n',
                               text + "\n\n" + '\n' + "x\n",
                               '\n' + peter_line.substr(0, peter_line.size() - 1),
                               text + '\n' + "\u2014 PeterNeumann\n",
                               text + '\n' + "\u2014  eA==\n",
                               text + '\n' + "\u2014 Peter+Neumann eHh4eHg=\n",
                               text + '\n' + "- PeterNeumann eHh4eHg=\n",
                               text + '\n' + "\u2014 PeterNeumann eHh4eA==\n",   // an id without a signature
                               text + '\n' + "\u2014 PeterNeumann eHh4eHh=\n",   // base64 with bits left over
                               text + '\n' + "\u2014 PeterNeumann  eHh4eHg=\n",  // two spaces
                               "\xff\n\n" + peter_line,
                               "a\tb\n\n" + peter_line,
                               "a\rb\n\n" + peter_line,
                               std::string("a\0b\n\n", 5) + peter_line};
  std::string many = text + '\n';
  for (int k = 0; k <= 100; ++k) many += peter_line;
  bad.push_back(many);
  bad.push_back(std::string(std::size_t{1} << 20U, 'x') + "\n\n" + peter_line);
  for (const std::string& note : bad)
    EXPECT_THROW(static_cast<void>(parse_note(note, "note")), Error) << note.substr(0, 200);
  EXPECT_NO_THROW(static_cast<void>(parse_note(many.substr(0, many.size() - peter_line.size()), "note")));
}

TEST(SignedNote, HasOneTextOnly) {
  const std::string note = text + '\n' + peter_line + enoch_line;
  const std::vector<PublicKey> both{key(peter_key), key(enoch_key)};
  for (std::size_t bit = 0; bit < 8 * note.size(); ++bit) {
    std::string changed = note;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    bool accepted = false;
    try {
      accepted = signers(changed, both).size() == 2;
    } catch (const Error&) {
    }
    EXPECT_FALSE(accepted) << bit;
  }
}

}  // namespace
}  // namespace rva
