#include "audit/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace rva {
namespace {

// The example of c2sp.org/tlog-checkpoint.
const std::string published =
    "example.com/behind-the-sofa\n20852163\nCsUYapGGPo4dkMgIAUqom/Xajj7h2fB2MPA3j2jxq2I=\n";

// The problem that parsing a text as a checkpoint shows.
void expect_refused(const std::string& text) {
  EXPECT_THROW(static_cast<void>(parse_checkpoint(text, "checkpoint")), Error) << text;
}

TEST(Checkpoint, IsThePublishedOne) {
  const Checkpoint checkpoint = parse_checkpoint(published, "checkpoint");
  EXPECT_EQ(checkpoint.origin, "example.com/behind-the-sofa");
  EXPECT_EQ(checkpoint.tree.size, 20852163U);
  EXPECT_EQ(hex_of(bytes_of(checkpoint.tree.root)),
            "0ac5186a91863e8e1d90c808014aa89bf5da8e3ee1d9f07630f0378f68f1ab62");
  EXPECT_EQ(text_of(checkpoint), published);
  EXPECT_EQ(parse_checkpoint(published + "extension\nanother\n", "checkpoint").tree.size, 20852163U);
}

TEST(Checkpoint, EveryOtherTextIsRefused) {
  const std::string root = "CsUYapGGPo4dkMgIAUqom/Xajj7h2fB2MPA3j2jxq2I=\n";
  for (std::size_t size = 0; size < published.size(); ++size) expect_refused(published.substr(0, size));
  for (const char* const size : {"", "-1", "+1", "01", "1 ", " 1", "0x1", "18446744073709551616", "1.0"})
    expect_refused("log\n" + std::string(size) + '\n' + root);
  expect_refused("\n1\n" + root);
  expect_refused("log\n1\nCsUYapGGPo4dkMgIAUqom/Xajj7h2fB2MPA3j2jxq2J=\n");
  expect_refused("log\n1\nCsUYapGGPo4=\n");
  expect_refused(published + "\nextension\n");
  expect_refused(published + "extension");
  EXPECT_EQ(parse_checkpoint("log\n18446744073709551615\n" + root, "checkpoint").tree.size,
            ~std::uint64_t{0});
}

TEST(Checkpoint, IsOpenedWithTheKeyOfItsLogAlone) {
  const SigningKey key = SigningKey::generate("example.com/log");
  const TreeHead tree{7, leaf_hash("root")};
  const std::string note = signed_checkpoint(tree, key);
  EXPECT_EQ(open_checkpoint(note, key.public_key(), "log").tree.root, tree.root);
  EXPECT_THROW(
      static_cast<void>(open_checkpoint(note, SigningKey::generate("example.com/log").public_key(), "log")),
      Error);
  SignedNote foreign{text_of(Checkpoint{"example.com/other", tree}), {}};
  sign(foreign, key);
  EXPECT_THROW(static_cast<void>(open_checkpoint(text_of(foreign), key.public_key(), "log")), Error);
  SignedNote no_checkpoint{"hello\n", {}};
  sign(no_checkpoint, key);
  EXPECT_THROW(static_cast<void>(open_checkpoint(text_of(no_checkpoint), key.public_key(), "log")), Error);
}

TEST(LogProof, IsReadAsItWasWritten) {
  const LogProof proof{73894, {leaf_hash("a"), leaf_hash("b")}, "log\n1\nroot\n\n\u2014 signature\n"};
  const std::string text = text_of(proof);
  EXPECT_EQ(text.substr(0, 36),
            "c2sp.org/tlog-proof@v1\nindex 73894\n" + base64_of(bytes_of(leaf_hash("a"))).substr(0, 1));
  const LogProof read = parse_log_proof(text, "proof");
  EXPECT_EQ(read.index, proof.index);
  EXPECT_EQ(read.path, proof.path);
  EXPECT_EQ(read.checkpoint, proof.checkpoint);
}

TEST(LogProof, EveryOtherTextIsRefused) {
  const std::string text = text_of(LogProof{1, {leaf_hash("a")}, "x\n"});
  const std::size_t end = text.size() - 2;  // of what comes before the checkpoint
  for (std::size_t size = 0; size < end; ++size)
    EXPECT_THROW(static_cast<void>(parse_log_proof(text.substr(0, size), "proof")), Error) << size;
  for (std::size_t at = 0; at < end; ++at) {
    std::string changed = text;
    changed[at] = '\x7f';
    EXPECT_THROW(static_cast<void>(parse_log_proof(changed, "proof")), Error) << at;
  }
  EXPECT_THROW(
      static_cast<void>(parse_log_proof(text_of(LogProof{1, std::vector<Digest>(65), "x\n"}), "proof")),
      Error);
}

// A proof is at most 4 KB at a million records.
TEST(LogProof, OfAMillionRecordsIsSmall) {
  const SigningKey key = SigningKey::generate("example.com/a-log-with-a-long-name");
  const std::vector<Digest> path(20, leaf_hash(""));
  EXPECT_LT(text_of(LogProof{999'999, path, signed_checkpoint({1'000'000, leaf_hash("")}, key)}).size(),
            4096U);
}

}  // namespace
}  // namespace rva
