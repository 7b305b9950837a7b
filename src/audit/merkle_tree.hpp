// The Merkle tree of an append-only log, and its proofs (RFC 6962, section 2.1; RFC 9162, section 2.1), with
// SHA-256. A tree is given by the hashes of its leaves, in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "audit/digest.hpp"

namespace rva {

/// The hash of the leaf of an entry.
[[nodiscard]] Digest leaf_hash(std::string_view entry);

/// The hash of an inner node.
[[nodiscard]] Digest node_hash(const Digest& left, const Digest& right);

/// The root, which states the whole content and its order; that of no leaves is the SHA-256 of nothing.
[[nodiscard]] Digest tree_root(std::span<const Digest> leaves);

/// The hashes from which is_included() computes the root: the leaf's sibling first.
/// @param index of the leaf, below the number of leaves
[[nodiscard]] std::vector<Digest> inclusion_proof(std::span<const Digest> leaves, std::size_t index);

/// The hashes from which is_consistent() computes both roots.
/// @param old_size from 0 to the number of leaves; the proof is empty for either
[[nodiscard]] std::vector<Digest> consistency_proof(std::span<const Digest> leaves, std::size_t old_size);

/// Where a tree has which size and root.
struct TreeHead {
  std::uint64_t size = 0;  ///< number of leaves
  Digest root{};           ///< tree_root()
};

/// Whether a leaf is at `index` of the tree (RFC 9162, section 2.1.3.2). Any arguments are allowed.
[[nodiscard]] bool is_included(const Digest& leaf, std::uint64_t index, const TreeHead& tree,
                               std::span<const Digest> proof);

/// Whether the old tree is a prefix of the new one (RFC 9162, section 2.1.4.2). The empty tree is a prefix of
/// every tree. Any arguments are allowed.
[[nodiscard]] bool is_consistent(const TreeHead& old_tree, const TreeHead& new_tree,
                                 std::span<const Digest> proof);

}  // namespace rva
