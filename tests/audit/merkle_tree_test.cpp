#include "audit/merkle_tree.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/random.hpp"

namespace rva {
namespace {

using Digests = std::vector<Digest>;

// The leaves and roots by which implementations of RFC 6962 are compared (certificate-transparency,
// transparency-dev/merkle: testonly/constants.go).
const std::vector<std::string> published_entries{
    "",
    std::string(1, '\0'),
    "\x10",
    "\x20\x21",
    "\x30\x31",
    "\x40\x41\x42\x43",
    "\x50\x51\x52\x53\x54\x55\x56\x57",
    "\x60\x61\x62\x63\x64\x65\x66\x67\x68\x69\x6a\x6b\x6c\x6d\x6e\x6f"};
const std::vector<std::string> published_roots{
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855",
    "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d",
    "fac54203e7cc696cf0dfcb42c92a1d9dbaf70ad9e621f4bd8d98662f00e3c125",
    "aeb6bcfe274b70a14fb067a5e5578264db0fa9b51af5e0ba159158f329e06e77",
    "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7",
    "4e3bbb1f7b478dcfe71fb631631519a3bca12c9aefca1612bfce4c13a86264d4",
    "76e67dadbcdf1e10e1b74ddc608abd2f98dfb16fbce75277b5232a127f2087ef",
    "ddb89be403809e325750d3d263cd78929c2942b7942a34b77e122c9594a74c8c",
    "5dc9da79a70659a9ad559cb701ded9a2ab9d823aad2f4960cfe370eff4604328"};

Digests published_leaves() {
  Digests leaves;
  for (const std::string& entry : published_entries) leaves.push_back(leaf_hash(entry));
  return leaves;
}

Digests digests_from(const std::vector<std::string>& texts) {
  Digests digests;
  for (const std::string& text : texts) digests.push_back(digest_from_hex(text).value());
  return digests;
}

Digests some_leaves(std::size_t count) {
  Digests leaves;
  for (std::size_t i = 0; i < count; ++i) leaves.push_back(leaf_hash(std::to_string(i)));
  return leaves;
}

Digests first(const Digests& leaves, std::size_t count) {
  return {leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(count)};
}

TreeHead head_of(const Digests& leaves) { return {leaves.size(), tree_root(leaves)}; }

// The heads of all trees of the first leaves, by their sizes.
std::vector<TreeHead> heads_of(const Digests& leaves) {
  std::vector<TreeHead> heads;
  for (std::size_t size = 0; size <= leaves.size(); ++size) heads.push_back(head_of(first(leaves, size)));
  return heads;
}

// MTH as RFC 6962, section 2.1 defines it, over entries and copies of them: the independent reference.
Digest defined_root(const std::vector<std::string>& entries) {
  if (entries.empty()) return sha256("");
  if (entries.size() == 1) return sha256(std::string("\0", 1) + entries[0]);
  std::size_t k = 1;
  while (2 * k < entries.size()) k *= 2;
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(k);
  const Digest left = defined_root({entries.begin(), middle});
  const Digest right = defined_root({middle, entries.end()});
  return sha256("\1" + std::string(left.begin(), left.end()) + std::string(right.begin(), right.end()));
}

// PATH as RFC 6962, section 2.1.1 defines it.
Digests defined_path(std::size_t m, const std::vector<std::string>& entries) {
  if (entries.size() <= 1) return {};
  std::size_t k = 1;
  while (2 * k < entries.size()) k *= 2;
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(k);
  const std::vector<std::string> left{entries.begin(), middle};
  const std::vector<std::string> right{middle, entries.end()};
  Digests path = m < k ? defined_path(m, left) : defined_path(m - k, right);
  path.push_back(defined_root(m < k ? right : left));
  return path;
}

TEST(MerkleTree, HasThePublishedRoots) {
  const Digests leaves = published_leaves();
  for (std::size_t size = 0; size <= leaves.size(); ++size)
    EXPECT_EQ(hex_of(bytes_of(tree_root(first(leaves, size)))), published_roots[size]) << size;
}

struct PublishedProof {
  std::size_t from;  // index of a leaf, or the old size
  std::size_t size;
  std::vector<std::string> proof;
};

TEST(MerkleTree, HasThePublishedInclusionProofs) {
  const std::vector<PublishedProof> examples{
      {0, 1, {}},
      {0,
       8,
       {"96a296d224f285c67bee93c30f8a309157f0daa35dc5b87e410b78630a09cfc7",
        "5f083f0a1a33ca076a95279832580db3e0ef4584bdff1f54c8a360f50de3031e",
        "6b47aaf29ee3c2af9af889bc1fb9254dabd31177f16232dd6aab035ca39bf6e4"}},
      {5,
       8,
       {"bc1a0643b12e4d2d7c77918f44e0f4f79a838b6cf9ec5b5c283e1f4d88599e6b",
        "ca854ea128ed050b41b35ffc1b87b8eb2bde461e9e3b5596ece6b9d5975a0ae0",
        "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7"}},
      {2, 3, {"fac54203e7cc696cf0dfcb42c92a1d9dbaf70ad9e621f4bd8d98662f00e3c125"}},
      {1,
       5,
       {"6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d",
        "5f083f0a1a33ca076a95279832580db3e0ef4584bdff1f54c8a360f50de3031e",
        "bc1a0643b12e4d2d7c77918f44e0f4f79a838b6cf9ec5b5c283e1f4d88599e6b"}}};
  const Digests leaves = published_leaves();
  for (const PublishedProof& example : examples) {
    const Digests tree = first(leaves, example.size);
    const Digests proof = digests_from(example.proof);
    EXPECT_EQ(inclusion_proof(tree, example.from), proof);
    EXPECT_TRUE(is_included(leaves[example.from], example.from, head_of(tree), proof));
  }
}

TEST(MerkleTree, HasThePublishedConsistencyProofs) {
  const std::vector<PublishedProof> examples{
      {1, 1, {}},
      {1,
       8,
       {"96a296d224f285c67bee93c30f8a309157f0daa35dc5b87e410b78630a09cfc7",
        "5f083f0a1a33ca076a95279832580db3e0ef4584bdff1f54c8a360f50de3031e",
        "6b47aaf29ee3c2af9af889bc1fb9254dabd31177f16232dd6aab035ca39bf6e4"}},
      {6,
       8,
       {"0ebc5d3437fbe2db158b9f126a1d118e308181031d0a949f8dededebc558ef6a",
        "ca854ea128ed050b41b35ffc1b87b8eb2bde461e9e3b5596ece6b9d5975a0ae0",
        "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7"}},
      {2,
       5,
       {"5f083f0a1a33ca076a95279832580db3e0ef4584bdff1f54c8a360f50de3031e",
        "bc1a0643b12e4d2d7c77918f44e0f4f79a838b6cf9ec5b5c283e1f4d88599e6b"}},
      {6,
       7,
       {"0ebc5d3437fbe2db158b9f126a1d118e308181031d0a949f8dededebc558ef6a",
        "b08693ec2e721597130641e8211e7eedccb4c26413963eee6c1e2ed16ffb1a5f",
        "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7"}}};
  const Digests leaves = published_leaves();
  for (const PublishedProof& example : examples) {
    const Digests tree = first(leaves, example.size);
    const Digests proof = digests_from(example.proof);
    EXPECT_EQ(consistency_proof(tree, example.from), proof);
    EXPECT_TRUE(is_consistent(head_of(first(leaves, example.from)), head_of(tree), proof));
  }
}

constexpr std::size_t largest = 70;

TEST(MerkleTree, EqualsTheDefinition) {
  std::vector<std::string> entries;
  for (std::size_t size = 0; size <= largest; ++size) {
    const Digests leaves = some_leaves(size);
    EXPECT_EQ(tree_root(leaves), defined_root(entries)) << size;
    for (std::size_t index = 0; index < size; ++index)
      EXPECT_EQ(inclusion_proof(leaves, index), defined_path(index, entries)) << index << " of " << size;
    entries.push_back(std::to_string(size));
  }
}

TEST(MerkleTree, EveryLeafIsIncludedAtItsIndexAlone) {
  const Digests leaves = some_leaves(largest);
  const std::vector<TreeHead> heads = heads_of(leaves);
  for (std::size_t size = 1; size <= largest; ++size) {
    const Digests tree = first(leaves, size);
    const TreeHead head = head_of(tree);
    for (std::size_t index = 0; index < size; ++index) {
      const Digests proof = inclusion_proof(tree, index);
      EXPECT_LE(proof.size(), 7U);
      for (std::size_t other = 0; other <= size; ++other) {
        EXPECT_EQ(is_included(leaves[index], other, head, proof), other == index);
        EXPECT_EQ(is_included(leaves[other % size], index, head, proof), other % size == index);
      }
      // A proof contains no size: one of another size may have the same form, but not the same root.
      for (std::size_t other = 0; other <= largest; ++other)
        EXPECT_EQ(is_included(leaves[index], index, heads[other], proof), other == size);
    }
  }
}

TEST(MerkleTree, EveryPrefixIsConsistentAndNothingElse) {
  const Digests leaves = some_leaves(largest);
  const std::vector<TreeHead> heads = heads_of(leaves);
  const Digest forged = leaf_hash("forged");
  for (std::size_t size = 1; size <= largest; ++size) {
    EXPECT_TRUE(is_consistent(heads[0], heads[size], consistency_proof(first(leaves, size), 0)));
    for (std::size_t old_size = 1; old_size <= size; ++old_size) {
      const Digests proof = consistency_proof(first(leaves, size), old_size);
      EXPECT_TRUE(is_consistent(heads[old_size], heads[size], proof)) << old_size << " of " << size;
      EXPECT_FALSE(is_consistent({old_size, forged}, heads[size], proof));
      EXPECT_FALSE(is_consistent(heads[old_size], {size, forged}, proof));
      if (old_size == size) continue;  // the proof is empty, as between any tree and itself
      for (std::size_t other = 1; other <= largest; ++other) {
        EXPECT_EQ(is_consistent(heads[other], heads[size], proof), other == old_size) << other;
        EXPECT_EQ(is_consistent(heads[old_size], heads[other], proof), other == size) << other;
      }
    }
  }
}

// Flips a bit of a digest, adds one, removes one, or swaps two that differ; false where there is nothing to
// change.
bool change(Digests& proof, Random& random) {
  switch (random.bits() % 4) {
    case 0:
      if (proof.empty()) return false;
      proof[random.bits() % proof.size()][random.bits() % 32] ^=
          static_cast<unsigned char>(1U << random.bits() % 8);
      return true;
    case 1:
      proof.insert(proof.begin() + static_cast<std::ptrdiff_t>(random.bits() % (proof.size() + 1)),
                   leaf_hash("added"));
      return true;
    case 2:
      if (proof.empty()) return false;
      proof.erase(proof.begin() + static_cast<std::ptrdiff_t>(random.bits() % proof.size()));
      return true;
    default:
      if (proof.size() < 2) return false;
      std::swap(proof[0], proof[1 + random.bits() % (proof.size() - 1)]);
      return true;
  }
}

TEST(MerkleTree, EveryChangedProofIsFound) {
  Random random(20);
  const Digests leaves = some_leaves(largest);
  int changed = 0;
  while (changed < 4000) {
    const std::size_t size = 1 + random.bits() % largest;
    const Digests tree = first(leaves, size);
    const std::size_t index = random.bits() % size;
    Digests proof = inclusion_proof(tree, index);
    if (change(proof, random)) {
      EXPECT_FALSE(is_included(leaves[index], index, head_of(tree), proof));
      ++changed;
    }
    const std::size_t old_size = 1 + index;
    Digests consistency = consistency_proof(tree, old_size);
    if (change(consistency, random)) {
      EXPECT_FALSE(is_consistent(head_of(first(leaves, old_size)), head_of(tree), consistency));
      ++changed;
    }
  }
}

TEST(MerkleTree, NoIndexAndNoSizeIsTooLarge) {
  constexpr std::uint64_t most = ~std::uint64_t{0};
  const Digest leaf = leaf_hash("");
  const Digests proof(64, leaf);
  EXPECT_FALSE(is_included(leaf, most, {most, leaf}, proof));
  EXPECT_FALSE(is_included(leaf, most - 1, {most, leaf}, proof));
  EXPECT_FALSE(is_included(leaf, 0, {0, tree_root({})}, {}));
  EXPECT_FALSE(is_consistent({most - 1, leaf}, {most, leaf}, proof));
  EXPECT_FALSE(is_consistent({most, leaf}, {1, leaf}, {}));
  EXPECT_FALSE(is_consistent({0, leaf}, {1, leaf}, {}));
  EXPECT_FALSE(is_consistent({1, leaf}, {2, leaf}, {}));
}

TEST(MerkleTree, LeavesAndNodesAreNeverConfused) {
  const Digests leaves = some_leaves(2);
  const std::string children = std::string(bytes_of(leaves[0])) + std::string(bytes_of(leaves[1]));
  EXPECT_NE(leaf_hash(children), tree_root(leaves));
}

}  // namespace
}  // namespace rva
