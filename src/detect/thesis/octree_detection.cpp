#include "detect/thesis/octree_detection.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/stopwatch.hpp"
#include "detect/regions/left_out.hpp"
#include "detect/thesis/octree_change.hpp"

namespace rva {
namespace {

Eigen::AlignedBox3f crop_of(const OctreeOptions& options) {
  constexpr float nearest_m = 0.05F;
  constexpr float aside_m = 1000.0F;
  return {Eigen::Vector3f(-aside_m, -static_cast<float>(options.above_m), nearest_m),
          Eigen::Vector3f(aside_m, static_cast<float>(options.below_m), static_cast<float>(options.far_m))};
}

PointCloud cloud_of(const DepthFrame& frame, const OctreeOptions& options, const char* side) {
  PointCloud cloud = deproject(frame.depth, frame.info.depth, frame.info.depth_unit_m, crop_of(options));
  if (cloud.points_m.empty())
    throw Error(std::string(side) + " capture", "no point is left of its first depth image",
                "crop less: raise the limits of distance and of height above and below the camera");
  return cloud;
}

Mask left_out_after(const Mask& left_out, const CaptureInfo& initial, const DepthFrame& final,
                    const RegisteredClouds& clouds) {
  if (left_out.empty()) return {};
  Image<float> final_m(final.depth.width(), final.depth.height());
  std::ranges::transform(final.depth.pixels(), final_m.pixels().begin(), [&](std::uint16_t units) {
    return static_cast<float>(units * final.info.depth_unit_m);
  });
  return carry_over(left_out, initial.depth, final.info.depth, final_m, clouds.final_from_initial.inverse());
}

}  // namespace

RegisteredClouds register_clouds(const DepthFrame& initial, const DepthFrame& final,
                                 const OctreeOptions& options, const Progress& progress) {
  RegisteredClouds clouds{cloud_of(initial, options, "initial"), cloud_of(final, options, "final")};
  clouds.final_from_initial = register_incrementally(clouds.initial, clouds.final, options.icp, progress);
  return clouds;
}

Comparison compare_clouds(const RegisteredClouds& clouds, const DepthFrame& final, double cell_m,
                          const Mask& left_out) {
  const DepthImage& depth = final.depth;
  Comparison comparison(depth.width(), depth.height());
  std::size_t measured = 0;
  std::size_t omitted = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    comparison.final_m[i] = static_cast<float>(depth[i] * final.info.depth_unit_m);
    if (is_left_out(left_out, i))
      ++omitted;
    else
      measured += depth[i] > 0 ? 1 : 0;
  }
  const std::vector<std::uint32_t>& pixels = clouds.final.pixels;
  for (const std::size_t position :
       points_in_new_cells(clouds.initial, clouds.final, clouds.final_from_initial, cell_m)) {
    if (is_left_out(left_out, pixels[position])) continue;
    comparison.changed[pixels[position]] = mask_set;
    comparison.evidence[pixels[position]] = 1.0F;
  }
  const auto compared = static_cast<std::size_t>(
      std::ranges::count_if(pixels, [&](std::uint32_t i) { return !is_left_out(left_out, i); }));
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(depth.size());
  };
  comparison.coverage.compared = share(compared);
  comparison.coverage.beyond_clip = share(measured - compared);
  comparison.coverage.invalid = share(depth.size() - measured - omitted);
  if (!left_out.empty()) comparison.coverage.left_out = share(omitted);
  return comparison;
}

Detection detect_by_octree(const Capture& initial, const Capture& final, const OctreeOptions& options,
                           const RegionOptions& regions, const Progress& progress, const Mask& left_out) {
  check_options(options);
  check_options(regions);
  Detection detection;
  Findings& findings = detection.findings;
  findings.method = "octree";
  findings.initial_frames = findings.final_frames = 1;
  state(options, findings.parameters);
  state(regions, findings.parameters);

  const Stopwatch start;
  const DepthImage before = initial.depth(0);
  const DepthImage after = final.depth(0);
  findings.runtime.load_ms = start.ms();
  const Stopwatch detect_start;
  const DepthFrame final_frame{after, final.info()};
  const RegisteredClouds clouds = register_clouds({before, initial.info()}, final_frame, options, progress);
  findings.final_from_initial = clouds.final_from_initial;
  detection.left_out = left_out_after(left_out, initial.info(), final_frame, clouds);
  Comparison comparison = compare_clouds(clouds, final_frame, options.cell_m, detection.left_out);
  findings.runtime.detect_ms = detect_start.ms();
  throw_if_interrupted();

  const Stopwatch regions_start;
  findings.findings = find_findings(comparison, regions, final.info().depth);
  findings.runtime.regions_ms = regions_start.ms();
  findings.runtime.total_ms = start.ms();
  findings.coverage = comparison.coverage;
  detection.changed = std::move(comparison.changed);
  detection.initial_m = std::move(comparison.initial_m);
  detection.final_m = std::move(comparison.final_m);
  detection.warnings.emplace_back(
      "the octree method reports newly visible surfaces as changes, does not detect removed objects, and "
      "does "
      "not estimate the error of its registration");
  return detection;
}

}  // namespace rva
