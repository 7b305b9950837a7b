#include "map/overlapping_views.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

#include "core/parallel.hpp"

namespace rva {
namespace {

constexpr int coarse_step_px = 8;
constexpr int fine_step_px = 4;
constexpr int window_px = 8;  // side of a patch, about that of the matcher's window

// The standard deviation of a residual, and the number of residuals whose errors are fully correlated
// (because of the matcher's window and its fixed pattern).
constexpr double residual_px = 0.15;
constexpr double erring_together = 100.0;

void add(const NormalEquations& pair, const ViewNumbers& numbers, const Transform& first_from_second,
         PoseEquations& sum) {
  const double by_variance = 1.0 / (residual_px * residual_px * erring_together);
  const auto first = static_cast<Eigen::Index>(6 * numbers.first);
  const auto second = static_cast<Eigen::Index>(6 * numbers.second);
  const TwistMatrix information = by_variance * pair.information.topLeftCorner<6, 6>();
  const Twist gradient = by_variance * pair.gradient.head<6>();
  // The step of the alignment is the second camera's motion in the first's frame, minus the first
  // camera's motion.
  const TwistMatrix seen = adjoint(first_from_second);
  const TwistMatrix mixed = -information * seen;
  sum.information.block<6, 6>(first, first) += information;
  sum.information.block<6, 6>(second, second) += seen.transpose() * information * seen;
  sum.information.block<6, 6>(first, second) += mixed;
  sum.information.block<6, 6>(second, first) += mixed.transpose();
  sum.gradient.segment<6>(first) -= gradient;
  sum.gradient.segment<6>(second) += seen.transpose() * gradient;
  for (const std::size_t view : {numbers.first, numbers.second}) {
    ViewResiduals& residuals = sum.views[view];
    ++residuals.neighbours;
    residuals.compared += pair.compared;
    residuals.agreeing += pair.agreeing;
    residuals.squares += pair.squares;
  }
}

}  // namespace

OverlappingViews::OverlappingViews(std::span<const MapView> views) {
  for (const MapView& view : views) {
    coarse_.emplace_back(view.depth, coarse_step_px, window_px);
    fine_.emplace_back(view.depth, fine_step_px, window_px);
  }
}

std::vector<ViewNumbers> OverlappingViews::pairs(std::span<const Transform> world_from_camera) const {
  assert(world_from_camera.size() == size());
  constexpr double least_overlap = 0.1;
  constexpr int every = 8;
  constexpr double any_reach_px = 1e3;
  std::vector<ViewNumbers> all;
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = i + 1; j < size(); ++j) all.push_back({i, j});
  }
  std::vector<std::uint8_t> overlaps(all.size());
  parallel_bands(static_cast<int>(all.size()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const auto [i, j] = all[static_cast<std::size_t>(k)];
      const Transform first_from_second = world_from_camera[i].inverse() * world_from_camera[j];
      const NormalEquations sum = rva::normal_equations(ViewPair(coarse_[i], coarse_[j], every),
                                                        {first_from_second, 0.0}, any_reach_px);
      overlaps[static_cast<std::size_t>(k)] = sum.compared > least_overlap * sum.samples ? 1 : 0;
    }
  });
  std::vector<ViewNumbers> result;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (overlaps[k] != 0) result.push_back(all[k]);
  }
  return result;
}

PoseEquations OverlappingViews::equations(std::span<const Transform> world_from_camera,
                                          std::span<const ViewNumbers> pairs,
                                          const PosesDescent& descent) const {
  assert(world_from_camera.size() == size());
  assert(descent.step_px == coarse_step_px || descent.step_px == fine_step_px);
  const std::deque<PlanarPatches>& patches = descent.step_px == fine_step_px ? fine_ : coarse_;
  std::vector<NormalEquations> sums(pairs.size());
  const auto between = [&](const ViewNumbers& pair) -> Transform {
    return world_from_camera[pair.first].inverse() * world_from_camera[pair.second];
  };
  parallel_bands(static_cast<int>(pairs.size()), [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      sums[k] =
          rva::normal_equations(ViewPair(patches[pairs[k].first], patches[pairs[k].second], descent.every),
                                {between(pairs[k]), 0.0}, descent.reach_px);
  });
  const auto unknowns = static_cast<Eigen::Index>(6 * size());
  PoseEquations result{Eigen::MatrixXd::Zero(unknowns, unknowns), Eigen::VectorXd::Zero(unknowns),
                       std::vector<ViewResiduals>(size())};
  for (std::size_t k = 0; k < pairs.size(); ++k) add(sums[k], pairs[k], between(pairs[k]), result);
  return result;
}

}  // namespace rva
