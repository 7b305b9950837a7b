// Captures without the depth that no light of the projector made.
#pragma once

#include "cloud/spatial_detection.hpp"

namespace rva {

/// Both sides, without depth where the infrared images under the projector show neither its dots nor other
/// light (beyond_projector()). Captures without such an image are as they were. What one image shows to be
/// without light is left out of the capture of the same pose on the other side, too: its depth would seem to
/// have come or gone.
struct LitSides {
  Captures initial;
  Captures final;
};

/// @param initial, final must outlive the result; captures of one pose have one position in both
/// @throws Error when an infrared image cannot be read
[[nodiscard]] LitSides within_projector_field(const Captures& initial, const Captures& final);

}  // namespace rva
