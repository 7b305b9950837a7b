// Whether images that should be under the lamp are.
#pragma once

#include <string>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// What is wrong with an image under the lamp: it is dark, saturated, or has the projector's dots. Empty
/// where nothing is; else a sentence without a full stop.
[[nodiscard]] std::string problem_under_lamp(const InfraredView& view);

}  // namespace rva
