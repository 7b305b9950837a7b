// Checks whether infrared images can be compared: their exposure, and whether they were lit.
#pragma once

#include <span>
#include <string>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// Describes what is wrong with an image: under the lamp, if it is dark, saturated or has the projector's
/// dots; under the projector, if it has hardly any dots or is saturated. Empty if nothing is wrong; else a
/// sentence without a full stop.
[[nodiscard]] std::string problem_of(const InfraredView& view, Light light);

/// The same for the views of both sides, as a warning that names the first capture with a problem; empty if
/// nothing is wrong.
[[nodiscard]] std::string warning_of(std::span<const InfraredView> initial,
                                     std::span<const InfraredView> final, Light light);

/// Brightness of an image in grey levels. Under the lamp it is the median, since most of a view is the same
/// before and after. Under the projector it is the mean, since the median lies between dots, at only a few
/// grey levels.
[[nodiscard]] float exposed_level(const Image<float>& grey, Light light);

/// The factor that scales the image to `level`, within a quarter and four: exposures differ by less, and a
/// darker image remains unlit.
[[nodiscard]] float scale_to_level(float level, const Image<float>& grey, Light light);

}  // namespace rva
