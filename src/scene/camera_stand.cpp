#include "scene/camera_stand.hpp"

#include <numbers>

#include "geometry/pan_tilt.hpp"

namespace rva {

Transform world_from_foot(const CameraStand& stand) {
  Transform foot(Eigen::Translation3d(stand.position_m));
  foot.rotate(Eigen::AngleAxisd(stand.heading_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()));
  return foot;
}

Transform world_from_camera(const CameraStand& stand) {
  return world_from_foot(stand) * foot_from_camera(PanTiltChain{}, {stand.pan_deg, stand.tilt_deg});
}

}  // namespace rva
