#include "audit/merkle_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <string>
#include <tuple>

namespace rva {
namespace {

// The number of leaves in the left subtree: the largest power of two below `size`, which is at least 2.
std::size_t left_size(std::size_t size) { return std::bit_floor(size - 1); }

bool is_odd(std::uint64_t number) { return (number & 1U) != 0; }

// SUBPROOF of RFC 6962, section 2.1.2.
void append_consistency(std::vector<Digest>& proof, std::span<const Digest> leaves, std::size_t old_size,
                        bool old_root_is_known) {
  if (old_size == leaves.size()) {
    if (!old_root_is_known) proof.push_back(tree_root(leaves));
    return;
  }
  const std::size_t left = left_size(leaves.size());
  if (old_size <= left) {
    append_consistency(proof, leaves.first(left), old_size, old_root_is_known);
    proof.push_back(tree_root(leaves.subspan(left)));
  } else {
    append_consistency(proof, leaves.subspan(left), old_size - left, false);
    proof.push_back(tree_root(leaves.first(left)));
  }
}

/// The way from a node up to the root: its index on its level, and that of the level's last node.
struct Climb {
  std::uint64_t index;
  std::uint64_t last;

  void rise() {
    index >>= 1U;
    last >>= 1U;
  }
  // The sibling is on the left where the node is a right child, or the last of its level.
  [[nodiscard]] bool sibling_is_left() const { return is_odd(index) || index == last; }
  // The last node of a level that has no sibling is that of the levels above, too.
  void skip_levels_without_sibling() {
    while (!is_odd(index) && index != 0) rise();
  }
};

// Whether a tree of no leaves, or of as many leaves as another, is a prefix of it: this needs no proof.
bool is_empty_or_same(const TreeHead& old_tree, const TreeHead& new_tree) {
  if (old_tree.size == new_tree.size) return old_tree.root == new_tree.root;
  return old_tree.size == 0 && old_tree.root == tree_root({});
}

}  // namespace

Digest leaf_hash(std::string_view entry) { return sha256(std::string(1, '\0').append(entry)); }

Digest node_hash(const Digest& left, const Digest& right) {
  std::array<unsigned char, 1 + 2 * std::tuple_size_v<Digest>> bytes{1};
  std::copy(right.begin(), right.end(), std::copy(left.begin(), left.end(), bytes.begin() + 1));
  return sha256(bytes_of(bytes));
}

Digest tree_root(std::span<const Digest> leaves) {
  if (leaves.empty()) return sha256({});
  if (leaves.size() == 1) return leaves.front();
  const std::size_t left = left_size(leaves.size());
  return node_hash(tree_root(leaves.first(left)), tree_root(leaves.subspan(left)));
}

std::vector<Digest> inclusion_proof(std::span<const Digest> leaves, std::size_t index) {
  assert(index < leaves.size());
  if (leaves.size() == 1) return {};
  const std::size_t left = left_size(leaves.size());
  const bool is_left = index < left;
  std::vector<Digest> proof = is_left ? inclusion_proof(leaves.first(left), index)
                                      : inclusion_proof(leaves.subspan(left), index - left);
  proof.push_back(tree_root(is_left ? leaves.subspan(left) : leaves.first(left)));
  return proof;
}

std::vector<Digest> consistency_proof(std::span<const Digest> leaves, std::size_t old_size) {
  assert(old_size <= leaves.size());
  std::vector<Digest> proof;
  if (old_size > 0) append_consistency(proof, leaves, old_size, true);
  return proof;
}

bool is_included(const Digest& leaf, std::uint64_t index, const TreeHead& tree,
                 std::span<const Digest> proof) {
  if (index >= tree.size) return false;
  Climb climb{index, tree.size - 1};
  Digest root = leaf;
  for (const Digest& sibling : proof) {
    if (climb.last == 0) return false;
    if (climb.sibling_is_left()) {
      root = node_hash(sibling, root);
      climb.skip_levels_without_sibling();
    } else {
      root = node_hash(root, sibling);
    }
    climb.rise();
  }
  return climb.last == 0 && root == tree.root;
}

bool is_consistent(const TreeHead& old_tree, const TreeHead& new_tree, std::span<const Digest> proof) {
  if (old_tree.size == 0 || old_tree.size >= new_tree.size)
    return proof.empty() && is_empty_or_same(old_tree, new_tree);
  std::vector<Digest> path(proof.begin(), proof.end());
  if (std::has_single_bit(old_tree.size)) path.insert(path.begin(), old_tree.root);
  if (path.empty()) return false;
  Climb climb{old_tree.size - 1, new_tree.size - 1};
  while (is_odd(climb.index)) climb.rise();
  Digest old_root = path.front();
  Digest new_root = path.front();
  for (const Digest& sibling : std::span(path).subspan(1)) {
    if (climb.last == 0) return false;
    if (climb.sibling_is_left()) {
      old_root = node_hash(sibling, old_root);
      new_root = node_hash(sibling, new_root);
      climb.skip_levels_without_sibling();
    } else {
      new_root = node_hash(new_root, sibling);
    }
    climb.rise();
  }
  return climb.last == 0 && old_root == old_tree.root && new_root == new_tree.root;
}

}  // namespace rva
