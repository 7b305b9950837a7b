// Whether infrared images can be compared: their exposure, and whether what is to light them did.
#pragma once

#include <span>
#include <string>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// What is wrong with an image: under the lamp, it is dark, saturated, or has the projector's dots; under the
/// projector, it has hardly any dots or is saturated. Empty where nothing is; else a sentence without a full
/// stop.
[[nodiscard]] std::string problem_of(const InfraredView& view, Light light);

/// The same for the views of both sides, as a warning that names the first capture with a problem; empty
/// where nothing is wrong.
[[nodiscard]] std::string warning_of(std::span<const InfraredView> initial,
                                     std::span<const InfraredView> final, Light light);

/// How bright an image is, in grey levels: under the lamp the middle of all levels, since most of a view is
/// the same before and after; between dots, the middle has few levels, and the mean is taken.
[[nodiscard]] float exposed_level(const Image<float>& grey, Light light);

/// What brings the image to `level`, by a factor of four at most, since exposures differ by less: what is
/// darker still has no light.
[[nodiscard]] float scale_to_level(float level, const Image<float>& grey, Light light);

}  // namespace rva
