// What mechanics leave behind, in its true size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.hpp"

namespace rva {

/// One kind of debris.
struct DebrisKind {
  std::string_view name;    ///< "collar-0.27": what scene files call it
  double size_mm;           ///< its largest extent
  std::string_view source;  ///< where its sizes come from: a standard, a product, a figure of the thesis
};

[[nodiscard]] const std::vector<DebrisKind>& debris_catalogue();

/// Null for an unknown name.
[[nodiscard]] const DebrisKind* find_debris_kind(std::string_view name);

/// Solids of a kind, in a frame whose origin is their centre of mass.
/// @param shape_seed for kinds that are never twice the same (rag, glove, swarf, wire): which one
/// @throws std::out_of_range for a kind that the catalogue lacks
[[nodiscard]] std::vector<Part> make_debris(std::string_view kind, std::uint64_t shape_seed);

}  // namespace rva
