#include "detect/thesis/incremental_icp.hpp"

#include <pcl/console/print.h>
#include <pcl/registration/icp_nl.h>

#include <cmath>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "detect/thesis/pcl_cloud.hpp"

namespace rva {
namespace {

// Constants of PCL's tutorial.
constexpr int iterations_a_step = 2;
constexpr double settled = 1e-6;
constexpr double shrink_m = 0.001;

}  // namespace

Transform register_incrementally(const PointCloud& initial, const PointCloud& final,
                                 const IncrementalIcpOptions& options, const Progress& progress) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // failure is reported below, once
  PclCloud::Ptr moved = to_pcl(initial);
  pcl::IterativeClosestPointNonLinear<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputTarget(to_pcl(final));
  icp.setMaximumIterations(iterations_a_step);
  icp.setTransformationEpsilon(settled);
  icp.setMaxCorrespondenceDistance(options.correspondence_m);
  Eigen::Matrix4f final_from_initial = Eigen::Matrix4f::Identity();
  Eigen::Matrix4f before = Eigen::Matrix4f::Zero();
  for (int step = 0; step < options.iterations; ++step) {
    throw_if_interrupted();
    icp.setInputSource(moved);
    const auto aligned = pcl::make_shared<PclCloud>();
    icp.align(*aligned);
    if (!icp.hasConverged())
      throw Error("initial and final", "too few points lie near each other to register the clouds",
                  "allow a larger distance of corresponding points, or use the spatial method");
    final_from_initial = icp.getFinalTransformation() * final_from_initial;
    const Eigen::Matrix4f last = icp.getLastIncrementalTransformation();
    const bool little = std::abs(static_cast<double>((last - before).sum())) < settled;
    const double nearer_m = icp.getMaxCorrespondenceDistance() - shrink_m;
    if (little && nearer_m > 0.0) icp.setMaxCorrespondenceDistance(nearer_m);
    before = last;
    moved = aligned;
    if (progress)
      progress("registration", static_cast<std::size_t>(step) + 1,
               static_cast<std::size_t>(options.iterations));
  }
  return Transform(final_from_initial.cast<double>());
}

}  // namespace rva
