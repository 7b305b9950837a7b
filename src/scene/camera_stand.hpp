// The camera's pose for a given position of the robot.
#pragma once

#include "geometry/transform.hpp"
#include "scene/scene.hpp"

namespace rva {

/// The pose of the foot's frame.
[[nodiscard]] Transform world_from_foot(const CameraStand& stand);

/// The pose of the depth imager, through the joint chain of the robot as built.
[[nodiscard]] Transform world_from_camera(const CameraStand& stand);

}  // namespace rva
