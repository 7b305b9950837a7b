#include "views/alignment.hpp"

#include "geometry/rigid_motion.hpp"
#include "views/surface_residuals.hpp"

namespace rva {
namespace {

using One = Eigen::Array<double, 1, 1>;

Vectors<One> as_vectors(const Eigen::Vector3d& point) {
  return {One(point.x()), One(point.y()), One(point.z())};
}

Eigen::Vector3d as_vector(const Vectors<One>& one) { return {one[0][0], one[1][0], one[2][0]}; }

AlignmentStep as_step(const BySteps<One>& one) {
  AlignmentStep step;
  for (std::size_t i = 0; i < one.size(); ++i) step[static_cast<Eigen::Index>(i)] = one.at(i)[0];
  return step;
}

// Equation 33 of docs/math.md.
Eigen::Vector3d gradient_of(const Eigen::Vector3d& point, const PlanarPatch& patch, const PlanarPatches& of) {
  return as_vector(gradient_at<One>(
      as_vectors(point), One(1.0 / point.z()), One(static_cast<double>(patch.slope_u) * of.camera().fx),
      One(static_cast<double>(patch.slope_v) * of.camera().fy), of.stereo().focal_baseline_m_px));
}

}  // namespace

// Equation 34 of docs/math.md.
Alignment moved(const Alignment& alignment, const AlignmentStep& step) {
  return {exp_of(step.head<6>()) * alignment.initial_from_final, alignment.offset_px + step[6]};
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
      points.push_back({position_m, gradient_of(position_m, patch, patches)});
    }
  }
  return points;
}

bool final_on_initial(const SurfaceSample& final_point, const PlanarPatches& initial,
                      const Alignment& alignment, AlignmentResidual& residual) {
  const Vectors<One> point = as_vectors(final_point.position_m);
  const SurfaceResiduals<One> found =
      final_on_initial(point, 1, initial, alignment.initial_from_final, alignment.offset_px);
  if (found.compared[0] == 0.0) return false;
  const Eigen::Vector3d own_gradient = alignment.initial_from_final.linear() * final_point.gradient;
  residual = {found.px[0], as_step(found.by_step),
              as_step(by_step(moved(alignment.initial_from_final, point), as_vectors(own_gradient), 1.0))};
  return true;
}

bool initial_on_final(const SurfaceSample& initial_point, const PlanarPatches& final,
                      const Alignment& alignment, const Transform& final_from_initial,
                      AlignmentResidual& residual) {
  const Vectors<One> point = as_vectors(initial_point.position_m);
  const SurfaceResiduals<One> found = initial_on_final(point, 1, final, alignment.initial_from_final,
                                                       final_from_initial, alignment.offset_px);
  if (found.compared[0] == 0.0) return false;
  residual = {found.px[0], as_step(found.by_step),
              as_step(by_step(point, as_vectors(-initial_point.gradient), -1.0))};
  return true;
}

double weight_of(double residual_px, double reach_px) { return biweight(One(residual_px), reach_px)[0]; }

}  // namespace rva
