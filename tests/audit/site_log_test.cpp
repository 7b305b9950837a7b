#include "audit/site_log.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/folder_lock.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

Digest leaf(std::size_t number) { return leaf_hash(std::to_string(number)); }

class SiteLogTest : public testing::Test {
 protected:
  void append(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) append_to_log(folder_, leaf(appended_++), key_);
  }
  [[nodiscard]] std::size_t size() const { return read_log(folder_, key_.public_key()).leaves.size(); }
  [[nodiscard]] std::string text(const char* file) const { return read_text_file(folder_ / file); }
  void expect_refused() {
    EXPECT_THROW(static_cast<void>(size()), Error);
    EXPECT_THROW(append(1), Error);
  }

  test::TemporaryFolder parent_;
  fs::path folder_ = parent_ / "log";
  SigningKey key_ = SigningKey::generate("example.com/log");
  std::size_t appended_ = 0;
};

TEST_F(SiteLogTest, GrowsRecordByRecord) {
  EXPECT_FALSE(is_log(folder_));
  std::vector<TreeHead> heads{{0, tree_root({})}};
  for (std::size_t index = 0; index < 20; ++index) {
    const LogProof proof = append_to_log(folder_, leaf(index), key_);
    const Checkpoint checkpoint = open_checkpoint(proof.checkpoint, key_.public_key(), "log");
    EXPECT_EQ(proof.index, index);
    EXPECT_TRUE(is_included(leaf(index), index, checkpoint.tree, proof.path));
    const SiteLog log = read_log(folder_, key_.public_key());
    EXPECT_EQ(log.leaves.size(), index + 1);
    EXPECT_EQ(log.note, proof.checkpoint);
    for (const TreeHead& earlier : heads)
      EXPECT_TRUE(is_consistent(earlier, checkpoint.tree, consistency_proof(log.leaves, earlier.size)));
    heads.push_back(checkpoint.tree);
  }
  EXPECT_TRUE(is_log(folder_));
}

// An append writes the leaf, then the checkpoint: stopped between or within these, the log is that of before.
TEST_F(SiteLogTest, IsThatOfBeforeWhereAnAppendWasStopped) {
  append(2);
  const std::string before = text("leaves.txt");
  const std::string checkpoint = text("checkpoint");
  append(1);
  const std::string after = text("leaves.txt");
  for (std::size_t length = before.size(); length <= after.size(); ++length) {
    write_file(folder_ / "leaves.txt", after.substr(0, length));
    write_file(folder_ / "checkpoint", checkpoint);
    EXPECT_EQ(size(), 2U) << length;
  }
  append_to_log(folder_, leaf_hash("other"), key_);
  EXPECT_EQ(read_log(folder_, key_.public_key()).leaves.back(), leaf_hash("other"));
}

TEST_F(SiteLogTest, BegunWithoutARecordGoesOn) {
  append(1);
  fs::remove(folder_ / "leaves.txt");
  expect_refused();
  fs::remove_all(folder_);
  fs::create_directory(folder_);
  write_file(folder_ / "checkpoint", signed_checkpoint({0, tree_root({})}, key_));
  EXPECT_EQ(size(), 0U);
  append(1);
  EXPECT_EQ(size(), 1U);
}

TEST_F(SiteLogTest, DamageIsFound) {
  append(3);
  const std::string leaves = text("leaves.txt");
  const std::string checkpoint = text("checkpoint");
  for (std::size_t at = 0; at < leaves.size(); at += 7) {
    std::string changed = leaves;
    changed[at] ^= 1;
    write_file(folder_ / "leaves.txt", changed);
    expect_refused();
    write_file(folder_ / "leaves.txt", leaves.substr(0, at));
    expect_refused();
  }
  write_file(folder_ / "leaves.txt", leaves);
  for (std::size_t at = 0; at < checkpoint.size(); at += 7) {
    std::string changed = checkpoint;
    changed[at] ^= 1;
    write_file(folder_ / "checkpoint", changed);
    expect_refused();
  }
  fs::remove(folder_ / "checkpoint");
  expect_refused();
}

TEST_F(SiteLogTest, OfAnotherKeyIsNotContinued) {
  append(1);
  EXPECT_THROW(append_to_log(folder_, leaf(1), SigningKey::generate("example.com/log")), Error);
  EXPECT_THROW(append_to_log(folder_, leaf(1), SigningKey::generate("example.com/other")), Error);
  EXPECT_EQ(size(), 1U);
}

TEST_F(SiteLogTest, UsedByAnotherProgramIsNotChanged) {
  append(1);
  const FolderLock lock(folder_);
  EXPECT_THROW(append(1), Error);
  EXPECT_EQ(size(), 1U);
}

}  // namespace
}  // namespace rva
