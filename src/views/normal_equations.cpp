#include "views/normal_equations.hpp"

#include <algorithm>

namespace rva {
namespace {

using Numbers = SampleBlock::Numbers;
using Vectors = std::array<Numbers, 3>;

std::vector<SampleBlock> blocks_of(const std::vector<SurfaceSample>& samples) {
  constexpr auto most = static_cast<std::size_t>(SampleBlock::most);
  std::vector<SampleBlock> blocks;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % most == 0) blocks.emplace_back();
    SampleBlock& block = blocks.back();
    if (block.count == 0) block.position_m.fill(Numbers::Ones());  // unused entries must be finite
    for (std::size_t axis = 0; axis < 3; ++axis)
      block.position_m.at(axis)[block.count] =
          static_cast<float>(samples[i].position_m[static_cast<Eigen::Index>(axis)]);
    ++block.count;
  }
  return blocks;
}

Vectors turned(const Eigen::Matrix3f& by, const Vectors& v) {
  return {by(0, 0) * v[0] + by(0, 1) * v[1] + by(0, 2) * v[2],
          by(1, 0) * v[0] + by(1, 1) * v[1] + by(1, 2) * v[2],
          by(2, 0) * v[0] + by(2, 1) * v[1] + by(2, 2) * v[2]};
}

Vectors moved(const Transform& by, const Vectors& v) {
  const Eigen::Vector3f shift = by.translation().cast<float>();
  Vectors result = turned(by.linear().cast<float>(), v);
  for (std::size_t axis = 0; axis < 3; ++axis) result.at(axis) += shift[static_cast<Eigen::Index>(axis)];
  return result;
}

/// Comparison of the samples of a block with the planes of a view.
struct Fall {
  Numbers compared = Numbers::Zero();  // 1 where there is a plane
  Numbers px = Numbers::Zero();        // disparity of the points minus that of the plane at their pixels
  Vectors gradient;                    // derivative of px by position
};

// Computes the same as fall() in alignment.cpp for a block of points.
// Equations 32 and 33 of docs/math.md.
Fall fall(const Vectors& points, Eigen::Index count, const PlanarPatches& onto) {
  constexpr float nearest_m = 0.05F;
  const Intrinsics& camera = onto.camera();
  const auto focal_baseline_m_px = static_cast<float>(onto.stereo().focal_baseline_m_px);
  const auto fx = static_cast<float>(camera.fx);
  const auto fy = static_cast<float>(camera.fy);
  const Numbers by_z = points[2].max(nearest_m).inverse();
  const Numbers u = fx * points[0] * by_z + static_cast<float>(camera.cx);
  const Numbers v = fy * points[1] * by_z + static_cast<float>(camera.cy);
  Numbers plane_px = Numbers::Zero();
  Numbers along_u = Numbers::Zero();
  Numbers along_v = Numbers::Zero();
  Fall result;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (points[2][i] < nearest_m) continue;
    const PlanarPatch* const patch = onto.find(u[i], v[i]);
    if (patch == nullptr) continue;
    result.compared[i] = 1.0F;
    plane_px[i] = onto.disparity_px(*patch, u[i], v[i]);
    along_u[i] = patch->slope_u * fx;
    along_v[i] = patch->slope_v * fy;
  }
  result.px = focal_baseline_m_px * by_z - plane_px;
  result.gradient = {-along_u * by_z, -along_v * by_z,
                     (along_u * points[0] + along_v * points[1] - focal_baseline_m_px) * by_z.square()};
  return result;
}

/// Residuals of a block and their derivatives by a step (AlignmentResidual).
struct Residuals {
  Numbers compared;
  Numbers px;
  std::array<Numbers, 7> by_step;
};

Residuals residuals_of(const Fall& fall, const Vectors& points, const Vectors& gradient, float by_offset,
                       double offset_px) {
  return {
      fall.compared,
      fall.px + by_offset * static_cast<float>(offset_px),
      {points[1] * gradient[2] - points[2] * gradient[1], points[2] * gradient[0] - points[0] * gradient[2],
       points[0] * gradient[1] - points[1] * gradient[0], gradient[0], gradient[1], gradient[2],
       Numbers::Constant(by_offset)}};
}

// Equation 35 of docs/math.md.
Residuals final_on_initial(const SampleBlock& block, const PlanarPatches& initial,
                           const Alignment& alignment) {
  const Vectors points = moved(alignment.initial_from_final, block.position_m);
  const Fall onto = fall(points, block.count, initial);
  return residuals_of(onto, points, onto.gradient, 1.0F, alignment.offset_px);
}

// Equation 36 of docs/math.md.
Residuals initial_on_final(const SampleBlock& block, const PlanarPatches& final, const Alignment& alignment,
                           const Transform& final_from_initial) {
  const Fall onto = fall(moved(final_from_initial, block.position_m), block.count, final);
  const Eigen::Matrix3f back = -alignment.initial_from_final.linear().cast<float>();
  return residuals_of(onto, block.position_m, turned(back, onto.gradient), -1.0F, alignment.offset_px);
}

// Equation 37 of docs/math.md.
void add(const Residuals& residuals, float reach_px, NormalEquations& sum) {
  const Numbers weight = residuals.compared * (1.0F - (residuals.px / reach_px).square()).max(0.0F).square();
  sum.compared += static_cast<double>(residuals.compared.sum());
  sum.agreeing += static_cast<double>(weight.sum());
  sum.squares += static_cast<double>((weight * residuals.px.square()).sum());
  sum.in_front += static_cast<double>((residuals.px >= reach_px).select(residuals.compared, 0.0F).sum());
  for (std::size_t i = 0; i < residuals.by_step.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Numbers weighted = weight * residuals.by_step.at(i);
    sum.gradient[row] += static_cast<double>((weighted * residuals.px).sum());
    for (std::size_t k = 0; k <= i; ++k)
      sum.information(row, static_cast<Eigen::Index>(k)) +=
          static_cast<double>((weighted * residuals.by_step.at(k)).sum());
  }
}

}  // namespace

ViewPair::ViewPair(const PlanarPatches& initial_patches, const PlanarPatches& final_patches, int every)
    : initial(initial_patches),
      final(final_patches),
      initial_samples(samples_of(initial, every)),
      final_samples(samples_of(final, every)),
      initial_blocks(blocks_of(initial_samples)),
      final_blocks(blocks_of(final_samples)) {}

// Equation 38 of docs/math.md.
double NormalEquations::score() const {
  // A pose that is off by the pitch of the stringers fits almost as well as the true one, but places
  // stringers in space that the other view saw through.
  constexpr double against = 3.0;
  return (agreeing - against * in_front) / std::max(1.0, samples);
}

NormalEquations normal_equations(const ViewPair& views, const Alignment& alignment, double reach_px) {
  NormalEquations sum;
  sum.samples = static_cast<double>(views.initial_samples.size() + views.final_samples.size());
  const auto reach = static_cast<float>(reach_px);
  for (const SampleBlock& block : views.final_blocks)
    add(final_on_initial(block, views.initial, alignment), reach, sum);
  const Transform final_from_initial = alignment.initial_from_final.inverse();
  for (const SampleBlock& block : views.initial_blocks)
    add(initial_on_final(block, views.final, alignment, final_from_initial), reach, sum);
  sum.information.triangularView<Eigen::StrictlyUpper>() = sum.information.transpose();
  return sum;
}

}  // namespace rva
