// Images under the lamp: their exposure, and whether the lamp was on.
#pragma once

#include <span>
#include <string>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// What is wrong with an image under the lamp: it is dark, saturated, or has the projector's dots. Empty
/// where nothing is; else a sentence without a full stop.
[[nodiscard]] std::string problem_under_lamp(const InfraredView& view);

/// The same for the views of both sides, as a warning that names the first capture with a problem; empty
/// where nothing is wrong.
[[nodiscard]] std::string warning_under_lamp(std::span<const InfraredView> initial,
                                             std::span<const InfraredView> final);

/// The middle of all grey levels: most of a view is the same before and after.
[[nodiscard]] float middle_level(const Image<float>& grey);

/// What brings the image's middle level to `level`, by a factor of four at most, since exposures differ by
/// less: what is darker still has no light.
[[nodiscard]] float scale_to_level(float level, const Image<float>& grey);

}  // namespace rva
