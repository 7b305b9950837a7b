#include "inspect/inspection_map.hpp"

#include <filesystem>
#include <memory>
#include <vector>

#include "core/path_text.hpp"
#include "map/map_cloud.hpp"
#include "map/map_view.hpp"
#include "map/point_files.hpp"
#include "map/pose_refinement.hpp"

namespace rva {

Transform map_from_camera(const CaptureInfo& info, const PanTiltChain& chain) {
  if (info.pose && info.pose->world_from_camera) return *info.pose->world_from_camera;
  return foot_from_camera(chain, {});
}

void write_inspection_map(const std::filesystem::path& file, const InspectionFolder& folder,
                          const Inspection& inspection, bool moved, const PanTiltChain& chain) {
  std::vector<MapView> loaded;
  std::vector<Transform> poses;
  for (int i = 0; i < static_cast<int>(inspection.views.size()) * inspection.dither; ++i) {
    const std::filesystem::path path =
        folder.capture(Side::final, inspection, i / inspection.dither, i % inspection.dither);
    const std::unique_ptr<Capture> capture = open_capture(path);
    loaded.push_back(moved ? load_map_view(*capture, printable(path))
                           : load_map_view(*capture, printable(path), PanTilt{}));
    poses.push_back(map_from_camera(capture->info(), chain));
  }
  if (moved && loaded.size() > 1) {
    poses.clear();
    for (const RefinedPose& pose : refine_poses(loaded, chain)) poses.push_back(pose.foot_from_camera);
  }
  write_ply(file, join_views(loaded, poses, {}), PointFrame::robot_foot);
}

std::vector<MapPoint> changed_points(const Detection& detection, const ColorImage& picture,
                                     const Intrinsics& camera, const Transform& map_from_camera) {
  const auto width = static_cast<std::uint32_t>(picture.width());
  std::vector<MapPoint> points;
  for (const Finding& finding : detection.findings.findings) {
    for (const std::uint32_t pixel : finding.pixels) {
      const double depth_m = detection.final_m[pixel];
      if (depth_m <= 0.0) continue;
      const std::uint32_t u = pixel % width;
      const std::uint32_t v = pixel / width;
      const Eigen::Vector3d position_m = map_from_camera * camera.deproject({u, v}, depth_m);
      points.push_back({position_m.cast<float>(), picture[pixel], 1});
    }
  }
  return points;
}

}  // namespace rva
