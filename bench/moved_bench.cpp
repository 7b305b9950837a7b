// Times detection with a moved camera and its counterparts in PCL in one process; writes
// rows for build/bench.json.
//
//   rva_moved_bench INITIAL_SCENE FINAL_SCENE OUT.json [--quick]
//
// --quick omits the thesis' registration of whole clouds, which takes a minute.
#include <fmt/format.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/gicp.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "bench/interleaved.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/findings/detection.hpp"
#include "detect/spatial/spatial_comparison.hpp"
#include "detect/thesis/octree_detection.hpp"
#include "detect/thesis/pcl_cloud.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "views/registration.hpp"

namespace rva::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames = 10;
constexpr int rounds = 15;
constexpr int rounds_of_gicp = 3;
constexpr float near_m = 0.05F;
constexpr float far_m = 1.2F;
constexpr float above_m = 0.3F;
volatile std::size_t sink = 0;  // keeps results from being optimised away

struct Side {
  CaptureInfo info;
  DepthImage first;
  DepthStatistics statistics;
  Transform world_from_camera;
};

Side take(const std::string& scene, std::uint64_t seed) {
  SimulatedCamera camera(load_scene(scene), StereoSensorOptions{}, seed, ColorFrames::none);
  const CaptureInfo info = camera.info();
  Side side{info, {}, DepthStatistics(info.depth.width, info.depth.height), camera.world_from_camera()};
  for (int i = 0; i < frames; ++i) {
    const DepthImage depth = camera.wait_for_frame()->depth;
    if (i == 0) side.first = depth;
    side.statistics.add(depth);
  }
  return side;
}

DepthView view_of(const Side& side) {
  return depth_view(side.statistics, side.info.depth, stereo_scale(side.info));
}

Eigen::AlignedBox3f crop() {
  constexpr float aside_m = 1000.0F;
  return {Eigen::Vector3f(-aside_m, -above_m, near_m), Eigen::Vector3f(aside_m, aside_m, far_m)};
}

PointCloud cloud_of(const Side& side, const Eigen::AlignedBox3f& within_m) {
  return deproject(side.first, side.info.depth, side.info.depth_unit_m, within_m);
}

// Deprojection with PCL alone: a loop over the pixels, as in its grabbers, and two filters. It reuses its
// memory, as our function does.
class PclDeprojection {
 public:
  const PclCloud& run(const Side& side) {
    const Intrinsics& camera = side.info.depth;
    all_->clear();
    all_->reserve(side.first.size());
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const auto z = static_cast<float>(side.first(u, v) * side.info.depth_unit_m);
        if (z <= 0.0F) continue;
        all_->emplace_back(static_cast<float>((u - camera.cx) / camera.fx) * z,
                           static_cast<float>((v - camera.cy) / camera.fy) * z, z);
      }
    }
    pass("z", near_m, far_m, all_, *near_);
    pass("y", -above_m, std::numeric_limits<float>::max(), near_, *low_);
    return *low_;
  }

 private:
  void pass(const char* axis, float from, float to, const PclCloud::Ptr& in, PclCloud& out) {
    filter_.setInputCloud(in);
    filter_.setFilterFieldName(axis);
    filter_.setFilterLimits(from, to);
    filter_.filter(out);
  }

  pcl::PassThrough<pcl::PointXYZ> filter_;
  PclCloud::Ptr all_ = pcl::make_shared<PclCloud>();
  PclCloud::Ptr near_ = pcl::make_shared<PclCloud>();
  PclCloud::Ptr low_ = pcl::make_shared<PclCloud>();
};

PclCloud::Ptr thinned(const PclCloud::Ptr& cloud) {
  constexpr float leaf_m = 0.02F;
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(leaf_m, leaf_m, leaf_m);
  auto result = pcl::make_shared<PclCloud>();
  grid.filter(*result);
  return result;
}

Transform register_with_gicp(const PclCloud::Ptr& initial, const PclCloud::Ptr& final) {
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
  gicp.setInputSource(thinned(initial));
  gicp.setInputTarget(thinned(final));
  PclCloud aligned;
  gicp.align(aligned);
  return Transform(gicp.getFinalTransformation().cast<double>());
}

Json error_of(const Transform& found, const Transform& truth) {
  const Transform off = truth.inverse() * found;
  return {{"mm", 1000.0 * off.translation().norm()},
          {"deg", Eigen::AngleAxisd(off.linear()).angle() * 180.0 / std::numbers::pi}};
}

Json row(const Candidate& ours, const Candidate& peer, const std::string& name) {
  return {{"name", name},
          {"ours_ms", ours.least_ms},
          {"peer", peer.name},
          {"peer_ms", peer.least_ms},
          {"ratio", peer.least_ms / ours.least_ms}};
}

void bench_deprojection(const Side& side, Json& rows) {
  PointCloud cloud;
  PclDeprojection with_pcl;
  const auto ours = [&] {
    deproject(side.first, side.info.depth, side.info.depth_unit_m, crop(), cloud);
    sink = sink + cloud.points_m.size();
  };
  std::vector<Candidate> candidates{{"ours", ours},
                                    {"pcl", [&] { sink = sink + with_pcl.run(side).size(); }}};
  time_interleaved(candidates, rounds);
  rows.push_back(row(candidates[0], candidates[1], "deproject"));
}

class MovedCamera {
 public:
  MovedCamera(const Side& initial, const Side& final)
      : initial_(initial),
        final_(final),
        truth_(final.world_from_camera.inverse() * initial.world_from_camera) {}

  void bench_registration(Json& rows) {
    const DepthView before = view_of(initial_);
    const DepthView after = view_of(final_);
    const PclCloud::Ptr cloud_before = to_pcl(cloud_of(initial_, whole_));
    const PclCloud::Ptr cloud_after = to_pcl(cloud_of(final_, whole_));
    Transform ours;
    Transform gicp;
    std::vector<Candidate> candidates{
        {"ours", [&] { ours = register_views(before, after).initial_from_final.inverse(); }},
        {"pcl-gicp", [&] { gicp = register_with_gicp(cloud_before, cloud_after); }}};
    time_interleaved(candidates, rounds_of_gicp);
    ours_ = candidates[0];
    rows.push_back(row(ours_, candidates[1], "registration"));
    rows.back()["ours_error"] = ours_error_ = error_of(ours, truth_);
    rows.back()["peer_error"] = error_of(gicp, truth_);
  }

  // The thesis' registration is timed once, since it takes a minute. It dominates the thesis' detection.
  void bench_whole(Json& rows) {
    std::vector<Candidate> candidates{{"ours", [&] { spatial(); }}};
    time_interleaved(candidates, rounds);
    Candidate icp{"thesis-icp", [&] { register_as_the_thesis(); }};
    std::vector<Candidate> once{icp};
    time_interleaved(once, 1);
    rows.push_back(row(ours_, once[0], "registration"));
    rows.back()["ours_error"] = ours_error_;
    rows.back()["peer_error"] = error_of(clouds_.final_from_initial, truth_);
    std::vector<Candidate> rest{{"octree", [&] { octree(); }}};
    time_interleaved(rest, rounds_of_gicp);
    rest[0].least_ms += once[0].least_ms;
    rows.push_back(row(candidates[0], rest[0], "moved-camera"));
  }

 private:
  // The whole comparison, from statistics to findings.
  void spatial() const {
    const DepthView before = view_of(initial_);
    const DepthView after = view_of(final_);
    const Registration registration = register_views(before, after);
    const Comparison comparison =
        compare_spatial(change_from_elsewhere(before, after, registration), {}).comparison;
    sink = sink + find_findings(comparison, {}, final_.info.depth).size();
  }

  void register_as_the_thesis() {
    clouds_ = register_clouds({initial_.first, initial_.info}, {final_.first, final_.info}, {}, Progress());
  }

  void octree() const {
    const Comparison comparison =
        compare_clouds(clouds_, {final_.first, final_.info}, OctreeOptions{}.cell_m);
    sink = sink + find_findings(comparison, {}, final_.info.depth).size();
  }

  const Side& initial_;
  const Side& final_;
  Transform truth_;  // final_from_initial
  RegisteredClouds clouds_;
  Candidate ours_;
  Json ours_error_;
  // The limits of the octree's default options.
  Eigen::AlignedBox3f whole_{Eigen::Vector3f(-10, -1, near_m), Eigen::Vector3f(10, 1, 2)};
};

}  // namespace
}  // namespace rva::bench

int main(int argc, char** argv) {
  const bool quick = argc == 5 && std::strcmp(argv[4], "--quick") == 0;
  if (argc != 4 && !quick) {
    fmt::print(stderr, "usage: rva_moved_bench INITIAL_SCENE FINAL_SCENE OUT.json [--quick]\n");
    return 2;
  }
  try {
    using namespace rva::bench;
    const Side initial = take(argv[1], 1);
    const Side final = take(argv[2], 2);
    Json rows = Json::array();
    bench_deprojection(initial, rows);
    MovedCamera moved(initial, final);
    moved.bench_registration(rows);
    if (!quick) moved.bench_whole(rows);
    rva::write_file(argv[3], rva::json_file_text(rows));
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_moved_bench: {}\n", error.what());
    return 1;
  }
}
