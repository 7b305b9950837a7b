// A robot's geometry as a settings file (docs/mapping.md).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "geometry/pan_tilt.hpp"

namespace rva {

/// Reads a robot's geometry. Axes must be unit vectors to 1e-3, since files have rounded numbers; in the
/// result they are normalised.
/// @throws Error naming the file and the field when the file is not a robot geometry or has another version;
///         when a value is missing or not a number; when a position is more than 2 m from the part that
///         carries it; when an axis does not have unit length; when the camera's axes are not at right angles
///         or are left-handed; when a servo's positive angle would turn against the direction that
///         geometry/pan_tilt.hpp defines
[[nodiscard]] PanTiltChain load_robot_geometry(const std::filesystem::path& path);

/// Checks that such a file may be written.
/// @param overwrite whether an earlier geometry may be replaced; any other file never is
/// @throws ExistsError, Error when something is there that may not be replaced
void require_replaceable_geometry(const std::filesystem::path& path, bool overwrite);

/// The content of such a file. The chain that is read back from it differs in the last digits only.
[[nodiscard]] nlohmann::ordered_json json_of(const PanTiltChain& chain);

}  // namespace rva
