#include "inspect/review_measurement.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/units.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/result_folder.hpp"
#include "inspect/inspection_map.hpp"
#include "map/map_cloud.hpp"
#include "map/view_capture.hpp"
#include "robot/dither.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

/// Standard deviation of a joint's angle. A joint rests anywhere within half a servo step of the angle that
/// it reports, and an even distribution deviates by its width over the root of twelve.
constexpr double rest_error_rad = radians(servo_step_deg) / (2.0 * std::numbers::sqrt3);

fs::path first_capture(const InspectionFolder& folder, const Inspection& inspection, Side side, int round,
                       int view) {
  return folder.side(side, round) /
         view_name(static_cast<std::size_t>(view) * static_cast<std::size_t>(inspection.dither));
}

UncertainView measured(const Capture& capture, const MeasureOptions& options) {
  const CaptureInfo& info = capture.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (std::size_t frame = 0; frame < capture.depth_frames(); ++frame) statistics.add(capture.depth(frame));
  return uncertain_view(statistics, info.depth, stereo_scale(info), options);
}

Transform final_from_initial(const fs::path& result) {
  const fs::path file = result / result_file::detections;
  try {
    const nlohmann::json detections = nlohmann::json::parse(read_text_file(file));
    return from_row_major(detections.at("final_from_initial").get<std::array<double, 16>>());
  } catch (const nlohmann::json::exception&) {
    throw Error("comparison", "does not state how its views were registered", "compare again");
  }
}

/// A view of the final side, of which only the description has been read.
struct FinalView {
  std::unique_ptr<Capture> capture;
  Transform foot_from_camera;

  [[nodiscard]] Eigen::Vector3d in_camera(const Eigen::Vector3d& in_foot_m) const {
    return foot_from_camera.inverse() * in_foot_m;
  }
  [[nodiscard]] bool sees(const Eigen::Vector3d& in_foot_m) const {
    const Eigen::Vector3d point = in_camera(in_foot_m);
    const Intrinsics& camera = capture->info().depth;
    return point.z() > 0.0 && camera.contains(camera.project(point));
  }
};

// A map has a point for each voxel, so that a point of it stands for what is around.
MeasureOptions for_voxels(const MeasureOptions& options, const Intrinsics& camera, double depth_m) {
  MeasureOptions result = options;
  const double spacing_m = MapCloudOptions{}.voxel_mm / 1000.0;
  result.pointing_px = std::hypot(options.pointing_px, camera.fx * spacing_m / depth_m / std::sqrt(12.0));
  return result;
}

// @return empty where the view shows another surface in front of the point
std::optional<MeasuredMapPoint> measured_in(const FinalView& view, const UncertainView& depth,
                                            const Eigen::Vector3d& in_foot_m, const MeasureOptions& options) {
  constexpr double same_surface_m = 0.02;
  const Eigen::Vector3d wanted_m = view.in_camera(in_foot_m);
  if (!view.sees(in_foot_m)) return std::nullopt;
  const PointOrReason found =
      surface_point(depth, depth.camera.project(wanted_m), for_voxels(options, depth.camera, wanted_m.z()));
  const auto* point = std::get_if<SurfacePoint>(&found);
  if (point == nullptr || (point->position_m - wanted_m).norm() > same_surface_m) return std::nullopt;
  const Eigen::Matrix3d turn = view.foot_from_camera.linear();
  return MeasuredMapPoint{{view.foot_from_camera * point->position_m,
                           turn * point->covariance_m2 * turn.transpose(), point->near_edge},
                          distance_of(*point, options)};
}

// The camera stands in the middle of a small sphere, and its rest turns what it sees about it.
void add_rest_error(MeasuredMapPoint& measured, const FinalView& view) {
  const Eigen::Vector3d from_camera_m = measured.point.position_m - view.foot_from_camera.translation();
  const double distance_m = from_camera_m.norm();
  const Eigen::Vector3d along = from_camera_m / distance_m;
  const double sideways_m = rest_error_rad * distance_m;
  measured.point.covariance_m2 +=
      sideways_m * sideways_m * (Eigen::Matrix3d::Identity() - along * along.transpose());
}

std::vector<FinalView> final_views(const InspectionFolder& folder, const Inspection& inspection,
                                   const RecordedComparison& comparison, const PanTiltChain& chain) {
  std::vector<FinalView> views;
  for (int view = 0; view < static_cast<int>(inspection.views.size()); ++view) {
    auto capture = open_capture(first_capture(folder, inspection, Side::final, comparison.final_round, view));
    const Transform pose = map_from_camera(capture->info(), chain);
    views.push_back({std::move(capture), pose});
  }
  return views;
}

// Views by their distance from the points.
std::vector<const FinalView*> nearest_first(const std::vector<FinalView>& views,
                                            const std::vector<Eigen::Vector3d>& points_m) {
  std::vector<const FinalView*> sorted;
  for (const FinalView& view : views) {
    if (std::ranges::all_of(points_m, [&](const Eigen::Vector3d& point) { return view.sees(point); }))
      sorted.push_back(&view);
  }
  const auto depth_m = [&](const FinalView* view) {
    double sum_m = 0.0;
    for (const Eigen::Vector3d& point : points_m) sum_m += view->in_camera(point).z();
    return sum_m;
  };
  std::ranges::sort(sorted, {}, depth_m);
  return sorted;
}

}  // namespace

MeasuredPicture measured_review(const InspectionFolder& folder, const Inspection& inspection,
                                const RecordedComparison& comparison, int view, Side side,
                                const MeasureOptions& options) {
  if (view < 0 || view >= static_cast<int>(inspection.views.size()) || comparison.final_round == 0 ||
      !inspection.initial)
    throw Error("view", "has no captures that can be measured", "compare the inspection again");
  const auto final =
      open_capture(first_capture(folder, inspection, Side::final, comparison.final_round, view));
  if (side == Side::final) return {measured(*final, options), std::nullopt};
  const auto initial =
      open_capture(first_capture(folder, inspection, Side::initial, inspection.initial->round, view));
  const fs::path result = InspectionFolder::result_in(folder.path() / comparison.folder, view);
  return {measured(*initial, options), PictureCamera{final->info().depth, final_from_initial(result)}};
}

MapMeasurement measure_in_map(const InspectionFolder& folder, const Inspection& inspection,
                              const RecordedComparison& comparison, const PanTiltChain& chain,
                              const std::array<Eigen::Vector3d, 2>& points_m, const MeasureOptions& options) {
  if (comparison.final_round == 0)
    throw Error("map", "has no captures that can be measured", "compare the inspection again");
  const std::vector<FinalView> views = final_views(folder, inspection, comparison, chain);
  MapMeasurement result;
  for (const FinalView* view : nearest_first(views, {points_m[0], points_m[1]})) {
    const UncertainView depth = measured(*view->capture, options);
    for (std::size_t i = 0; i < 2; ++i) result.points[i] = measured_in(*view, depth, points_m[i], options);
    if (!result.points[0] || !result.points[1]) continue;
    result.length = length_between(result.points[0]->point, result.points[1]->point, options);
    return result;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    result.points[i].reset();
    for (const FinalView* view : nearest_first(views, {points_m[i]})) {
      result.points[i] = measured_in(*view, measured(*view->capture, options), points_m[i], options);
      if (!result.points[i]) continue;
      add_rest_error(*result.points[i], *view);
      break;
    }
  }
  if (result.points[0] && result.points[1])
    result.length = length_between(result.points[0]->point, result.points[1]->point, options);
  return result;
}

}  // namespace rva
