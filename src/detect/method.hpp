// The detection methods: their names, and the options that each of them uses.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/enum_names.hpp"

namespace rva {

/// The methods of detection (docs/detection.md).
enum class DetectionMethod {
  automatic,   ///< calibrated if the camera stood still, spatial if it moved
  constant,    ///< static camera: algorithm 2 of the thesis
  gaussian,    ///< static camera: algorithm 3 of the thesis
  calibrated,  ///< static camera: against a noise model learnt from the captures
  spatial,     ///< moved camera: by comparing free space
  octree,      ///< moved camera: the pipeline of the thesis
};

/// The names by which the command line and `detections.json` refer to the methods.
template <>
inline constexpr auto enum_names<DetectionMethod> = std::to_array<EnumName<DetectionMethod>>({
    {DetectionMethod::automatic, "auto"},
    {DetectionMethod::constant, "constant"},
    {DetectionMethod::gaussian, "gaussian"},
    {DetectionMethod::calibrated, "calibrated"},
    {DetectionMethod::spatial, "spatial"},
    {DetectionMethod::octree, "octree"},
});

/// Whether a method reports both where a part is and where it was: the thesis' methods report only what came
/// nearer.
[[nodiscard]] bool shows_both_ends(DetectionMethod method);

/// Names of the options (OptionField::name) that have an effect with a method; other options have none.
[[nodiscard]] std::vector<std::string> options_of(DetectionMethod method);

}  // namespace rva
