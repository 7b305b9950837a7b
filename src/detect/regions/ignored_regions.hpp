// Regions of the view that the user leaves out of a comparison: a moving hose, a screen, another bay behind
// a hole.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "depth/image.hpp"
#include "detect/regions/regions.hpp"

namespace rva {

/// Corners in pixels of the baseline's depth image, at least three. The last is connected to the first.
using Polygon = std::vector<Eigen::Vector2d>;

/// A pixel is left out if its centre lies in an `ignore` polygon, or if there are `within` polygons and it
/// lies in none of them.
struct IgnoredRegions {
  std::vector<Polygon> ignore;
  std::vector<Polygon> within;

  [[nodiscard]] bool empty() const { return ignore.empty() && within.empty(); }
  bool operator==(const IgnoredRegions&) const = default;
};

/// Limits of a region file: polygons in either list, and corners of a polygon.
inline constexpr std::size_t most_polygons = 200;
inline constexpr std::size_t most_corners = 1000;

/// The mask of pixels that are left out; empty if there are no regions.
[[nodiscard]] Mask mask_of(const IgnoredRegions& regions, int width, int height);

/// The outline of the pixels of a box, half a pixel outside the centres of the outer ones.
[[nodiscard]] Polygon polygon_of(const Box& box);

/// Adds a rectangle to those outside which everything is left out.
/// @param width, height size of the baseline's depth image, in whose pixels the box is
/// @throws OptionError of the option `within` when the box contains no pixel of the image
void add_within(IgnoredRegions& regions, const Box& box, int width, int height);

/// Parses `{"format": "rva-regions", "version": 1, "ignore": [[[u, v], ...], ...], "within":
/// [...]}` (docs/detection.md).
/// @param source name of the text in error messages
/// @throws Error naming the polygon that is malformed
[[nodiscard]] IgnoredRegions parse_regions(const std::string& text, const std::string& source);
[[nodiscard]] nlohmann::ordered_json json_of(const IgnoredRegions& regions);

/// Reads a region file, or a picture in which every pixel that is not black is left out. The content decides
/// which it is.
/// @param width, height size of the baseline's depth image
/// @throws Error when it is neither, or the picture has another size
[[nodiscard]] Mask read_ignored_mask(const std::filesystem::path& file, int width, int height);

/// Sets in `mask` every pixel that is set in `more`. Either may be empty.
void unite(Mask& mask, const Mask& more);

}  // namespace rva
