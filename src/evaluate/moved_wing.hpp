// Wings in which the robot was lifted out and put back elsewhere.
#pragma once

#include <cstdint>

#include "evaluate/random_wing.hpp"
#include "sim/scene/scene.hpp"

namespace rva {

/// How the camera came back.
enum class CameraReturn {
  elsewhere,  ///< the robot was lifted out and put back
  near,       ///< the robot stayed, but came to rest one or two servo steps off in both joints
  exact,      ///< the robot stayed and came back to the same steps
  rest,  ///< so does it, and each pose of either side rests anywhere within half a step of what it reports
};

/// One bay, seen before and after the work.
struct MovedWing {
  Scene before;  ///< without debris, and before a mechanic's changes
  Scene after;   ///< with both
};

/// A bay as of random_wing(). Robots stand within the bay, 0.18 m and more from either rib, 0.05 to
/// 0.25 m from the near spar, and look at the middle of the bay, give or take 5 degrees, tilted down by 16 to
/// 30; put elsewhere, they are 0.15 to 0.4 m apart and turned against each other by up to 15 degrees. Five
/// pieces of debris are big (flashlights, a screwdriver, a socket, a roll of tape, a glove, a clip, a rag),
/// four small (collars, bolts, nut plates), or twelve before a camera that stays, which sees smaller things;
/// fewer where no place is found.
[[nodiscard]] MovedWing random_moved_wing(std::uint64_t seed, CameraReturn how,
                                          const BayFeatures& features = {});

}  // namespace rva
