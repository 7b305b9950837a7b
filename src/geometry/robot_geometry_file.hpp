// A robot's chain of joints as a settings file (docs/mapping.md).
#pragma once

#include <filesystem>
#include <string>

#include "geometry/pan_tilt.hpp"

namespace rva {

/// Axes are unit vectors to 1e-3, since files hold rounded numbers, and are exactly so in the result.
/// @throws Error naming the file and the field: not a robot geometry, of another version, something missing
/// or
///         not a number, further than 2 m from what carries it, an axis without unit length, axes of a camera
///         that are not at right angles or left-handed, a servo whose positive angle would turn the other way
///         than geometry/pan_tilt.hpp says
[[nodiscard]] PanTiltChain load_robot_geometry(const std::filesystem::path& path);

/// The same text, of a chain. What it is read back to differs in the last digits only.
[[nodiscard]] std::string robot_geometry_json(const PanTiltChain& chain);

}  // namespace rva
