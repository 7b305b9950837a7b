// The stiffeners that run along the span.
#pragma once

#include "sim/scene/wing_bay.hpp"

namespace rva {

/// Along x and centred on it, its foot on z = 0, its web (a hat's crown) over y = 0.
[[nodiscard]] TriangleMesh stringer(const WingBay::Stringers& form, double length_m);

/// How much of the chord one takes up.
[[nodiscard]] double stringer_width_m(const WingBay::Stringers& form);

}  // namespace rva
