// The detection methods: their names, and the options that each of them uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

enum class DetectionMethod {
  automatic,   ///< calibrated if the camera stood still, spatial if it moved
  constant,    ///< static camera: algorithm 2 of the thesis
  gaussian,    ///< static camera: algorithm 3 of the thesis
  calibrated,  ///< static camera: against a noise model learnt from the captures
  spatial,     ///< moved camera: by comparing free space
  octree,      ///< moved camera: the pipeline of the thesis
};

/// All methods, in the order in which they are listed to users.
[[nodiscard]] std::vector<DetectionMethod> detection_methods();

/// The name by which the command line and `detections.json` refer to a method.
[[nodiscard]] std::string_view name_of(DetectionMethod method);
/// @return empty if no method has this name
[[nodiscard]] std::optional<DetectionMethod> detection_method_from_name(std::string_view name);

/// Names of the options (OptionField::name) that have an effect with a method; other options have none.
[[nodiscard]] std::vector<std::string> options_of(DetectionMethod method);

}  // namespace rva
