#include "cloud/agreement.hpp"

#include <algorithm>

namespace rva {
namespace {

void add(const AlignmentResidual& residual, double reach_px, Agreement& sum) {
  sum.compared += 1.0;
  const double weight = weight_of(residual.px, reach_px);
  if (weight <= 0.0) {
    if (residual.px > 0.0) sum.in_front += 1.0;
    return;
  }
  sum.agreeing += weight;
  sum.gradient += weight * residual.px * residual.by_step;
  sum.information.selfadjointView<Eigen::Lower>().rankUpdate(residual.by_step, weight);
}

}  // namespace

double Agreement::score() const {
  // Stringers a pitch off agree almost as well as those in place; but what they stand in was seen through.
  constexpr double against = 3.0;
  return (agreeing - against * in_front) / std::max(1.0, samples);
}

Agreement agreement(const ViewPair& views, const Alignment& alignment, double reach_px) {
  Agreement sum;
  sum.samples = static_cast<double>(views.initial_points.size() + views.final_points.size());
  AlignmentResidual residual;
  for (const SurfacePoint& point : views.final_points) {
    if (final_on_initial(point, views.initial, alignment, residual)) add(residual, reach_px, sum);
  }
  const Transform final_from_initial = alignment.initial_from_final.inverse();
  for (const SurfacePoint& point : views.initial_points) {
    if (initial_on_final(point, views.final, alignment, final_from_initial, residual))
      add(residual, reach_px, sum);
  }
  sum.information.triangularView<Eigen::StrictlyUpper>() = sum.information.transpose();
  return sum;
}

}  // namespace rva
