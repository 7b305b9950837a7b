#include "views/normal_equations.hpp"

#include <algorithm>

#include "views/surface_residuals.hpp"

namespace rva {
namespace {

using Numbers = SampleBlock::Numbers;
using Residuals = SurfaceResiduals<Numbers>;

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

// Equation 37 of docs/math.md.
void add(const Residuals& residuals, float reach_px, NormalEquations& sum) {
  const Numbers weight = residuals.compared * biweight(residuals.px, reach_px);
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
  const auto& [initial_from_final, offset_px] = alignment;
  for (const SampleBlock& block : views.final_blocks)
    add(final_on_initial(block.position_m, block.count, views.initial, initial_from_final, offset_px), reach,
        sum);
  const Transform final_from_initial = initial_from_final.inverse();
  for (const SampleBlock& block : views.initial_blocks)
    add(initial_on_final(block.position_m, block.count, views.final, initial_from_final, final_from_initial,
                         offset_px),
        reach, sum);
  sum.information.triangularView<Eigen::StrictlyUpper>() = sum.information.transpose();
  return sum;
}

}  // namespace rva
