#include "map/rig.hpp"

#include "robot/dither.hpp"

namespace rva {

PanTilt approach_and_settle(const Rig& rig, const PanTilt& waypoint, std::size_t settling_frames) {
  const PanTilt joints = approach(rig.robot, waypoint, rig.clock);
  rig.camera.drop_waiting();
  for (std::size_t i = 0; i < settling_frames; ++i) static_cast<void>(rig.camera.wait_for_frame());
  return joints;
}

}  // namespace rva
