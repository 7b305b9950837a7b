// Random wings for studies in which the camera moves between the two sides.
#pragma once

#include <cstdint>

#include "core/enum_names.hpp"
#include "evaluate/random_wing.hpp"
#include "scene/scene.hpp"

namespace rva {

/// How the camera returned for the final side.
enum class CameraReturn {
  elsewhere,  ///< the robot was removed and put back at another position
  near,       ///< the robot stayed, but came to rest one or two servo steps off in both joints
  exact,      ///< the robot stayed and returned to the same servo steps
  rest,       ///< as `exact`, but each pose of either side is off by up to half a step from the reported one
};
/// The names that the command line and evaluation.json use.
template <>
inline constexpr auto enum_names<CameraReturn> = std::to_array<EnumName<CameraReturn>>({
    {CameraReturn::elsewhere, "elsewhere"},
    {CameraReturn::exact, "exact"},
    {CameraReturn::near, "near"},
    {CameraReturn::rest, "rest"},
});

/// One bay, seen before and after the work.
struct MovedWing {
  Scene before;  ///< without debris, work and traces
  Scene after;   ///< with debris, and with work and traces if the features include them
};

/// A bay from random_wing(). Robots stand inside the bay, at least 0.18 m from either rib and 0.05 to 0.25 m
/// from the near spar. They face the middle of the bay to within 5 degrees, tilted down by 16 to 30 degrees.
/// With CameraReturn::elsewhere, the positions of the two sides are 0.15 to 0.4 m apart and their headings
/// differ by up to 15 degrees. Five pieces of debris are drawn from big kinds (flashlights, a screwdriver, a
/// socket, a roll of tape, a glove, a clip, a rag) and four from small kinds (collars, bolts, nut plates);
/// twelve small ones in view of a camera that stays, which detects smaller debris. There are fewer if no free
/// position is found.
[[nodiscard]] MovedWing random_moved_wing(std::uint64_t seed, CameraReturn how,
                                          const BayFeatures& features = {});

}  // namespace rva
