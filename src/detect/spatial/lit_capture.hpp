// Captures without depth that was measured beyond the light of the projector.
#pragma once

#include "detect/spatial/spatial_detection.hpp"

namespace rva {

/// Both sides, without depth where the infrared images under the projector show neither its dots nor other
/// light (beyond_projector()). Captures without such an image are unchanged. A region that is unlit in one
/// image is also removed from the capture with the same pose on the other side; otherwise its depth would
/// seem to have appeared or gone missing.
struct LitSides {
  Captures initial;
  Captures final;
};

/// Removes depth beyond the light of the projector.
/// @param initial, final must outlive the result; captures of one pose have the same index in both
/// @throws Error when an infrared image cannot be read
[[nodiscard]] LitSides within_projector_field(const Captures& initial, const Captures& final);

}  // namespace rva
