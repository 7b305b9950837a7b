// The kinds of debris that mechanics leave behind, in true size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace rva {

/// One kind of debris.
struct DebrisKind {
  std::string_view name;    ///< name in scene files, such as "collar-0.27"
  double size_mm;           ///< largest extent
  std::string_view source;  ///< source of the dimensions: a standard, a product, a figure of the thesis
};

/// All kinds of debris.
[[nodiscard]] const std::vector<DebrisKind>& debris_catalogue();

/// Objects outside the catalogue, by which it is measured whether a classifier calls them unknown: everyday
/// objects from the trade, and last "random-shape", of which each seed gives another. Scene files and random
/// wings do not use them.
[[nodiscard]] const std::vector<DebrisKind>& unlisted_kinds();

/// Null for a name that the catalogue lacks.
[[nodiscard]] const DebrisKind* find_debris_kind(std::string_view name);

/// The solids of one piece, in metres, in a frame whose origin is their centre of volume, which serves as the
/// centre of mass.
/// @param kind       name in debris_catalogue() or unlisted_kinds()
/// @param shape_seed seed of the shape for kinds that vary (rag, glove, swarf, wire, tape, random-shape)
/// @throws std::out_of_range for any other kind
[[nodiscard]] std::vector<Part> make_debris(std::string_view kind, std::uint64_t shape_seed);

}  // namespace rva
