// The stiffeners that run along the span.
#pragma once

#include "scene/wing/wing_bay.hpp"

namespace rva {

/// A stringer along x, centred on x = 0, with its foot on z = 0 and its web (the crown of a hat) over y = 0.
[[nodiscard]] TriangleMesh stringer(const WingBay::Stringers& form, double length_m);

/// The extent of a stringer along the chord.
[[nodiscard]] double stringer_width_m(const WingBay::Stringers& form);

}  // namespace rva
