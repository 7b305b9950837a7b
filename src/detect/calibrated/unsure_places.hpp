// Where a stereo matcher is unsure of what it sees.
#pragma once

#include <cstdint>

#include "detect/calibrated/disparity_change.hpp"

namespace rva {

/// What differs between the places where the matcher is sure and those where it is not.
template <typename Of>
struct ByPlace {
  Of sure;
  Of unsure;

  [[nodiscard]] const Of& at(std::uint8_t is_unsure) const { return is_unsure != 0 ? unsure : sure; }
};

/// Set where disparity varies more over time, all around, than at four fifths of the pixels, or where depth
/// is missing all around in both captures: beside holes, steps and highlights a match that held throughout
/// one capture may be another in the next. There a change of the same size is likelier to be none. What
/// debris does to the depth around it is in one capture only, and makes no place unsure by its holes.
[[nodiscard]] Mask unsure_places(const DisparityChange& change);

}  // namespace rva
