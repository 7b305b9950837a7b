// Groups changed pixels into regions, as specified by drawChanges in the thesis (appendix B).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/options.hpp"
#include "depth/image.hpp"

namespace rva {

/// Options of the grouping of changed pixels.
struct RegionOptions {
  int min_blob_px = 0;
  double join_px = 30.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.min_blob_px, OptionField{"min-blob", "px", 0, 1e9, "blobs of fewer pixels are left out"});
    visit(self.join_px,
          OptionField{"join", "px", 0, 1e6, "blobs whose contours come nearer than this share a box"});
  }
};

/// A rectangle of whole pixels: columns [x, x + width), rows [y, y + height).
struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  auto operator<=>(const Box&) const = default;
};

/// A changed region of the image.
struct Region {
  Box box;
  /// Indices of its changed pixels in row-major order, ascending.
  std::vector<std::uint32_t> pixels;
};

/// Groups the 8-connected blobs of at least min_blob pixels: blobs whose contours come nearer to each other
/// than `join`, directly or in a chain, form one region. Regions are sorted by their boxes from top to
/// bottom, then from left to right.
///
/// The distance is that of the thesis: between the corners of the contours as OpenCV's CHAIN_APPROX_SIMPLE
/// keeps them (ends of straight runs), including those of holes. So two long straight borders may run closer
/// than `join` and stay apart, and a hole that lies `join` or more from its blob's outer border makes a
/// region of its own, nested in the other, whose pixels are those of the blob within the hole's box. The cost
/// is linear in pixels and about linear in blobs.
/// @param changed pixels other than 0 are changed
[[nodiscard]] std::vector<Region> find_regions(const Mask& changed, const RegionOptions& options);

}  // namespace rva
