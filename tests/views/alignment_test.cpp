#include "views/alignment.hpp"

#include <gtest/gtest.h>

#include "tests/views/box_room.hpp"
#include "views/normal_equations.hpp"

namespace rva {
namespace {

class AlignmentTest : public testing::Test {
 protected:
  const Transform initial_pose_ = test::pose(0.05, 0.0, 3.0);
  const Transform final_pose_ = test::pose(-0.04, 0.03, -4.0);
  const DepthView initial_view_ = test::view_of(test::bay(), initial_pose_);
  const DepthView final_view_ = test::view_of(test::bay(), final_pose_);
  const PlanarPatches initial_{initial_view_, 8, 8};
  const PlanarPatches final_{final_view_, 8, 8};
  const Alignment truth_{initial_pose_.inverse() * final_pose_, 0.0};
};

TEST_F(AlignmentTest, ResidualsVanishWhereViewsLieOverEachOther) {
  int compared = 0;
  int small = 0;
  AlignmentResidual residual;
  for (const SurfaceSample& point : samples_of(final_, 1)) {
    if (!final_on_initial(point, initial_, truth_, residual)) continue;
    ++compared;
    small += std::abs(residual.px) < 0.02 ? 1 : 0;
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(small, 0.9 * compared) << "the rest is seen by one view alone";
}

// Against differences, every component of the step; how many could be checked.
template <typename ResidualOf>
int check_derivatives(const ResidualOf& residual_of, const Alignment& at) {
  constexpr double h = 1e-6;
  AlignmentResidual here;
  if (!residual_of(at, here) || std::abs(here.px) > 0.5) return 0;
  int checked = 0;
  for (int k = 0; k < 7; ++k) {
    AlignmentResidual ahead;
    AlignmentResidual behind;
    if (!residual_of(moved(at, h * AlignmentStep::Unit(k)), ahead)) continue;
    if (!residual_of(moved(at, -h * AlignmentStep::Unit(k)), behind)) continue;
    const double slope = (ahead.px - behind.px) / (2 * h);
    if (std::abs(slope) > 1e3) continue;  // the point fell onto another patch in between
    EXPECT_NEAR(here.by_step[k], slope, 1e-3 * std::abs(slope) + 1e-3);
    ++checked;
  }
  return checked;
}

TEST_F(AlignmentTest, DerivativesAreThoseOfTheResidual) {
  const Alignment off =
      moved(truth_, (AlignmentStep() << 0.003, -0.002, 0.004, 0.002, -0.003, 0.004, 0.05).finished());
  int checked = 0;
  for (const SurfaceSample& point : samples_of(final_, 4)) {
    const auto residual_of = [&](const Alignment& at, AlignmentResidual& residual) {
      return final_on_initial(point, initial_, at, residual);
    };
    checked += check_derivatives(residual_of, off);
  }
  for (const SurfaceSample& point : samples_of(initial_, 4)) {
    const auto residual_of = [&](const Alignment& at, AlignmentResidual& residual) {
      return initial_on_final(point, final_, at, at.initial_from_final.inverse(), residual);
    };
    checked += check_derivatives(residual_of, off);
  }
  EXPECT_GT(checked, 500);
}

TEST_F(AlignmentTest, SlopesOfBothViewsAgreeOnOneSurface) {
  AlignmentResidual residual;
  int compared = 0;
  int alike = 0;
  for (const SurfaceSample& point : samples_of(final_, 2)) {
    if (!final_on_initial(point, initial_, truth_, residual) || std::abs(residual.px) > 0.02) continue;
    const AlignmentStep own = residual.by_step_of_own / residual.by_step_of_own.norm();
    const AlignmentStep other = residual.by_step / residual.by_step.norm();
    alike += own.dot(other) > 0.98 ? 1 : 0;
    ++compared;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(alike, 0.95 * compared) << "but where a patch bends over a corner";
}

// One by one, in double precision.
void add(const AlignmentResidual& residual, double reach_px, NormalEquations& sum) {
  const double weight = weight_of(residual.px, reach_px);
  sum.compared += 1.0;
  sum.agreeing += weight;
  sum.squares += weight * residual.px * residual.px;
  sum.in_front += residual.px >= reach_px ? 1.0 : 0.0;
  sum.gradient += weight * residual.px * residual.by_step;
  sum.information += weight * residual.by_step * residual.by_step.transpose();
}

TEST_F(AlignmentTest, NormalEquationsAreTheSumOverSamples) {
  const Alignment off =
      moved(truth_, (AlignmentStep() << 0.02, -0.01, 0.03, 0.04, -0.03, 0.06, 0.05).finished());
  const ViewPair views(initial_, final_, 2);
  const Transform final_from_initial = off.initial_from_final.inverse();
  for (const double reach_px : {1.0, 6.0}) {
    NormalEquations wanted;
    AlignmentResidual residual;
    for (const SurfaceSample& sample : samples_of(final_, 2)) {
      if (final_on_initial(sample, initial_, off, residual)) add(residual, reach_px, wanted);
    }
    for (const SurfaceSample& sample : samples_of(initial_, 2)) {
      if (initial_on_final(sample, final_, off, final_from_initial, residual))
        add(residual, reach_px, wanted);
    }
    const NormalEquations sum = normal_equations(views, off, reach_px);
    EXPECT_GT(wanted.compared, 300.0);
    if (reach_px < 2.0) {
      EXPECT_GT(wanted.in_front, 10.0);
    }
    // In single precision, one of many samples falls onto the next patch.
    EXPECT_NEAR(sum.compared, wanted.compared, 1.0);
    EXPECT_NEAR(sum.in_front, wanted.in_front, 1.0);
    EXPECT_NEAR(sum.agreeing, wanted.agreeing, 0.5);
    EXPECT_NEAR(sum.squares, wanted.squares, 0.01 * wanted.squares);
    EXPECT_LT((sum.gradient - wanted.gradient).norm(), 0.01 * wanted.gradient.norm());
    EXPECT_LT((sum.information - wanted.information).norm(), 0.01 * wanted.information.norm());
  }
}

TEST(TukeysWeight, FallsFromOneToNothing) {
  EXPECT_EQ(weight_of(0.0, 0.6), 1.0);
  EXPECT_EQ(weight_of(0.6, 0.6), 0.0);
  EXPECT_EQ(weight_of(-7.0, 0.6), 0.0);
  EXPECT_GT(weight_of(0.1, 0.6), weight_of(0.2, 0.6));
}

}  // namespace
}  // namespace rva
