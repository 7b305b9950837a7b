#include "views/alignment.hpp"

namespace rva {
namespace {

// Derivative, by the point's position, of its disparity minus that of the plane at its pixel.
// Equation 33 of docs/math.md.
Eigen::Vector3d gradient_at(const Eigen::Vector3d& point, const PlanarPatch& patch, const PlanarPatches& of) {
  const double by_z = 1.0 / point.z();
  const double along_u = static_cast<double>(patch.slope_u) * of.camera().fx;
  const double along_v = static_cast<double>(patch.slope_v) * of.camera().fy;
  return by_z * Eigen::Vector3d(
                    -along_u, -along_v,
                    (along_u * point.x() + along_v * point.y() - of.stereo().focal_baseline_m_px) * by_z);
}

struct Fall {
  double px = 0.0;
  Eigen::Vector3d gradient;
};

// Equation 32 of docs/math.md.
bool fall(const Eigen::Vector3d& point, const PlanarPatches& onto, Fall& result) {
  constexpr double nearest_m = 0.05;
  if (point.z() < nearest_m) return false;
  const Intrinsics& camera = onto.camera();
  const double by_z = 1.0 / point.z();
  const double u = camera.fx * point.x() * by_z + camera.cx;
  const double v = camera.fy * point.y() * by_z + camera.cy;
  const PlanarPatch* patch = onto.find(u, v);
  if (patch == nullptr) return false;
  result.px = onto.stereo().focal_baseline_m_px * by_z - onto.disparity_px(*patch, u, v);
  result.gradient = gradient_at(point, *patch, onto);
  return true;
}

// Equation 35 of docs/math.md.
AlignmentStep by_step(const Eigen::Vector3d& point, const Eigen::Vector3d& gradient, double by_offset) {
  AlignmentStep step;
  step << point.cross(gradient), gradient, by_offset;
  return step;
}

}  // namespace

// Equation 34 of docs/math.md.
Alignment moved(const Alignment& alignment, const AlignmentStep& step) {
  const Eigen::Vector3d rotation = step.head<3>();
  const double angle = rotation.norm();
  Transform motion(Eigen::Translation3d(Eigen::Vector3d(step.segment<3>(3))));
  if (angle > 0.0) motion.rotate(Eigen::AngleAxisd(angle, rotation / angle));
  return {motion * alignment.initial_from_final, alignment.offset_px + step[6]};
}

std::vector<SurfaceSample> samples_of(const PlanarPatches& patches, int every) {
  std::vector<SurfaceSample> points;
  for (int row = every / 2; row < patches.rows(); row += every) {
    for (int column = every / 2; column < patches.columns(); column += every) {
      const PlanarPatch& patch = patches.at(column, row);
      if (patch.disparity_px <= 0.0F) continue;
      const double depth_m = patches.stereo().depth_m(static_cast<double>(patch.disparity_px));
      const Eigen::Vector3d position_m =
          patches.camera().deproject({patches.centre_px(column), patches.centre_px(row)}, depth_m);
      points.push_back({position_m, gradient_at(position_m, patch, patches)});
    }
  }
  return points;
}

// Equations 32 and 35 of docs/math.md.
bool final_on_initial(const SurfaceSample& final_point, const PlanarPatches& initial,
                      const Alignment& alignment, AlignmentResidual& residual) {
  const Eigen::Vector3d point = alignment.initial_from_final * final_point.position_m;
  Fall onto;
  if (!fall(point, initial, onto)) return false;
  residual.px = onto.px + alignment.offset_px;
  residual.by_step = by_step(point, onto.gradient, 1.0);
  residual.by_step_of_own = by_step(point, alignment.initial_from_final.linear() * final_point.gradient, 1.0);
  return true;
}

// A step moves the frame of the final view; relative to it, the initial point moves the opposite way.
// Equation 36 of docs/math.md.
bool initial_on_final(const SurfaceSample& initial_point, const PlanarPatches& final,
                      const Alignment& alignment, const Transform& final_from_initial,
                      AlignmentResidual& residual) {
  Fall onto;
  if (!fall(final_from_initial * initial_point.position_m, final, onto)) return false;
  residual.px = onto.px - alignment.offset_px;
  residual.by_step =
      by_step(initial_point.position_m, -(alignment.initial_from_final.linear() * onto.gradient), -1.0);
  residual.by_step_of_own = by_step(initial_point.position_m, -initial_point.gradient, -1.0);
  return true;
}

double weight_of(double residual_px, double reach_px) {
  const double ratio = residual_px / reach_px;
  const double left = 1.0 - ratio * ratio;
  return left > 0.0 ? left * left : 0.0;
}

}  // namespace rva
