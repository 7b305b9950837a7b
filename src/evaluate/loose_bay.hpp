// Random bays with one loose part, before and after the structure was rocked.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scene/scene.hpp"

namespace rva {

/// A bay with a loose part, of which each side has another position.
struct LooseBay {
  Scene before;                    ///< with the part where it was
  Scene after;                     ///< with the part where it is
  Eigen::Vector3d was_m{0, 0, 0};  ///< middle of the part before, in the frame of the camera
  Eigen::Vector3d is_m{0, 0, 0};   ///< the same after
};

/// A bay of random_wing() with one loose part of about 10 mm (a collar of 0.36 or 0.44 in, or a nut M6) on a
/// stringer or the skin, in full view and within 0.6 m of the camera. The structure was rocked: the part
/// moved by 5 mm in a random direction on its surface, and turned by up to 20 degrees.
[[nodiscard]] LooseBay random_loose_bay(std::uint64_t seed);

}  // namespace rva
