// How well a robot comes back to a pose, measured by the camera that it carries.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/joint_turn.hpp"
#include "map/rig.hpp"

namespace rva {

/// Options of the measurement.
struct RepeatabilityOptions {
  int returns = 16;         ///< to each pose
  int frames = 5;           ///< whose mean is one picture
  double leave_deg = 10.0;  ///< by how much each joint turns away before a return

  static void describe(auto&& self, auto&& visit) {
    visit(self.returns, OptionField{"returns", "", 4, 1000,
                                    "to each pose; as many from smaller as from larger angles, if a "
                                    "multiple of four"});
    visit(self.frames, OptionField{"frames", "", 1, 100, "whose mean is one picture"});
    visit(self.leave_deg,
          OptionField{"leave", "deg", 2, 60, "by how much each joint turns away before a return"});
  }
};

/// The side from which a joint arrived.
enum class ArrivedFrom { smaller, larger };
/// The names in JSON.
template <>
inline constexpr auto enum_names<ArrivedFrom> = std::to_array<EnumName<ArrivedFrom>>({
    {ArrivedFrom::smaller, "smaller"},
    {ArrivedFrom::larger, "larger"},
});

/// One return to a pose.
struct MeasuredReturn {
  ArrivedFrom pan = ArrivedFrom::smaller;   ///< angles of the first joint
  ArrivedFrom tilt = ArrivedFrom::smaller;  ///< angles of the second joint
  PanTilt reported;                         ///< by the servos, at rest; not used for any figure
  JointTurn turn;                           ///< from the first arrival, as the camera sees it
};

/// All returns to one pose.
struct PoseReturns {
  PanTilt pose;                           ///< the target
  PanTilt reported;                       ///< by the servos at the first arrival
  std::vector<JointTurn> still{};         ///< pictures after the first one without a motion: the noise
  PanTilt known{};                        ///< what the servos report of a small turn away
  JointTurn seen{};                       ///< the same turn, as the camera sees it
  std::vector<MeasuredReturn> returns{};  ///< in the order in which they were made
};

/// The result of the measurement.
struct Repeatability {
  std::string pictures;            ///< which were compared, for the user
  std::vector<PoseReturns> poses;  ///< in the order of the given ones
};

/// Measures by how much the camera misses each pose when it comes back.
///
/// Each pose is approached from smaller angles in both joints (robot/dither.hpp). The picture there is the
/// first one, further ones without a motion show the noise, and a turn by six servo steps shows whether the
/// camera sees the robot's motion at all. The robot then leaves in the four diagonal directions in turn and
/// comes back in one move, so that each joint arrives from smaller angles in half of the returns, and from
/// larger ones in the other half. Turns are those of the camera's pictures (JointTurnGauge), not reported
/// ones.
/// @param rig      its base is not used
/// @param poses    at least one; with `leave_deg` around each within the robot's limits
/// @param progress "returns", called after each return while the robot is still there, and at each pose's
///                 first arrival
/// @throws UsageError  when an option is out of range, or a pose or what is around it is beyond the limits
/// @throws Error       when the camera sees too little, or something else than the robot's turns; as
///                     DotFreePictures, Robot and Camera
/// @throws Interrupted after stopping the robot
[[nodiscard]] Repeatability measure_repeatability(const Rig& rig, const std::vector<PanTilt>& poses,
                                                  const RepeatabilityOptions& options,
                                                  const Progress& progress);

}  // namespace rva
