// All pieces assigned to all planned parts at once.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "plan/part_fit.hpp"
#include "plan/pieces.hpp"

namespace rva {

/// A planned part.
struct Part {
  std::size_t item = 0;              ///< index in the plan
  std::optional<std::size_t> place;  ///< index in the item's places, if it has any
  std::optional<std::size_t> piece;  ///< that it was assigned
};

/// What a piece may be: for each item of the plan, empty where it cannot be a part of it.
using Fits = std::vector<std::optional<PartFit>>;

/// The parts of a plan with the pieces that they were assigned, in the order of the plan: as many parts as
/// possible have one; each piece has one if possible, several only if it covers them and no other piece can
/// be them; distances, as shares of the tolerances, are least in sum.
/// @param fits for each piece, in an order that does not depend on that of the findings
[[nodiscard]] std::vector<Part> assign_parts(const std::vector<PictureItem>& items,
                                             const std::vector<Piece>& pieces, const std::vector<Fits>& fits);

}  // namespace rva
