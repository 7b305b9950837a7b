// Where the camera is when the robot stands somewhere.
#pragma once

#include "geometry/transform.hpp"
#include "sim/scene/scene.hpp"

namespace rva {

[[nodiscard]] Transform world_from_foot(const CameraStand& stand);

/// Of the depth imager, through the chain of joints of the robot that is built.
[[nodiscard]] Transform world_from_camera(const CameraStand& stand);

}  // namespace rva
