// Parts of the view that a person leaves out of a comparison: a hose that moves, a screen, another bay behind
// a hole.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "depth/image.hpp"
#include "detect/regions.hpp"

namespace rva {

/// Corners in pixels of the baseline's depth image, at least three; the last is joined with the first.
using Polygon = std::vector<Eigen::Vector2d>;

/// A pixel is left out where its centre lies in an ignored polygon, or where there are polygons to stay
/// within and it lies in none of them.
struct IgnoredRegions {
  std::vector<Polygon> ignore;
  std::vector<Polygon> within;

  [[nodiscard]] bool empty() const { return ignore.empty() && within.empty(); }
  bool operator==(const IgnoredRegions&) const = default;
};

/// What a file of regions may hold at most.
inline constexpr std::size_t most_polygons = 200;
inline constexpr std::size_t most_corners = 1000;

/// Set where a pixel is left out. An empty mask where nothing is.
[[nodiscard]] Mask mask_of(const IgnoredRegions& regions, int width, int height);

/// The rectangle of the box's pixels, borders included.
[[nodiscard]] Polygon polygon_of(const Box& box);

/// From `{"format": "rva-regions", "version": 1, "ignore": [[[u, v], ...], ...], "within": [...]}`
/// (docs/detection.md).
/// @param place what to call the text in an error
/// @throws Error naming the polygon that is malformed
[[nodiscard]] IgnoredRegions parse_regions(const std::string& text, const std::string& place);
[[nodiscard]] std::string to_json(const IgnoredRegions& regions);

/// A file of regions, or a picture in which every pixel that is not black is left out, told apart by its
/// content.
/// @param width, height of the baseline's depth image
/// @throws Error when it is neither, or the picture has another size
[[nodiscard]] Mask read_ignored_mask(const std::filesystem::path& file, int width, int height);

/// Adds what is set in `more` to `mask`; either may be empty.
void unite(Mask& mask, const Mask& more);

}  // namespace rva
