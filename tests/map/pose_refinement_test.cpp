#include "map/pose_refinement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "map/overlapping_views.hpp"
#include "tests/map/box_bay.hpp"

namespace rva {
namespace {

using test::BoxBayView;
using test::PoseError;
using testing::HasSubstr;

std::vector<MapView> seen(const std::vector<BoxBayView>& how) {
  std::vector<MapView> views;
  for (const BoxBayView& view : how) views.push_back(test::box_bay_view(view));
  return views;
}

PoseError worst(const std::vector<RefinedPose>& poses, const std::vector<BoxBayView>& how) {
  PoseError worst;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PoseError error =
        test::error_of(poses[i].foot_from_camera, foot_from_camera({}, test::true_joints(how[i])));
    worst = {std::max(worst.mm, error.mm), std::max(worst.deg, error.deg)};
  }
  return worst;
}

TEST(OverlappingViews, GradientIsThatOfTheWeightedSquares) {
  const std::vector<MapView> views =
      seen({{{0, -20}, {}, 0.0, 1}, {{15, -22}, {}, 0.0, 2}, {{-15, -20}, {}, 0.0, 3}});
  std::vector<Transform> poses;
  for (const MapView& view : views) poses.push_back(foot_from_camera({}, view.joints));
  const OverlappingViews overlapping(views);
  const auto pairs = overlapping.pairs(poses);
  ASSERT_EQ(pairs.size(), 3U);
  // Where all is in place, the information is the growth of the gradient: with a far reach, weights hardly
  // change.
  const PosesDescent far{4, 2, 50.0};
  const PoseEquations here = overlapping.equations(poses, pairs, far);
  for (Eigen::Index k = 0; k < 18; ++k) {
    Twist motion = Twist::Zero();
    motion[k % 6] = 2e-4;
    std::vector<Transform> moved = poses;
    Transform& pose = moved[static_cast<std::size_t>(k / 6)];
    pose = pose * exp_of(motion);
    const PoseEquations there = overlapping.equations(moved, pairs, far);
    const Eigen::VectorXd grown = there.gradient - here.gradient;
    const Eigen::VectorXd expected = here.information.col(k) * 2e-4;
    EXPECT_LT((grown - expected).norm(), 0.15 * expected.norm()) << k;
  }
}

TEST(OverlappingViews, MovingAllTogetherChangesNothing) {
  const std::vector<MapView> views = seen({{{0, -20}, {}, 0.0, 1}, {{15, -22}, {}, 0.0, 2}});
  std::vector<Transform> poses{foot_from_camera({}, views[0].joints), foot_from_camera({}, views[1].joints)};
  const OverlappingViews overlapping(views);
  const auto pairs = overlapping.pairs(poses);
  const PoseEquations here = overlapping.equations(poses, pairs, {8, 4, 2.0});
  const Transform elsewhere = foot_from_camera({}, {70.0, -50.0});
  for (Transform& pose : poses) pose = elsewhere * pose;
  const PoseEquations there = overlapping.equations(poses, pairs, {8, 4, 2.0});
  EXPECT_TRUE(there.information.isApprox(here.information, 1e-3));
  EXPECT_EQ(there.views[0].compared, here.views[0].compared);
}

TEST(PoseRefinement, CorrectsTheServos) {
  const std::vector<BoxBayView> how = test::twelve_views();
  const std::vector<MapView> views = seen(how);
  std::vector<RefinedPose> by_joints(views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
    by_joints[i].foot_from_camera = foot_from_camera({}, views[i].joints);
  EXPECT_GT(worst(by_joints, how).deg, 0.15);
  const std::vector<RefinedPose> refined = refine_poses(views, {});
  EXPECT_LT(worst(refined, how).deg, 0.1);
  EXPECT_LT(worst(refined, how).mm, 1.5);
  for (const RefinedPose& pose : refined) {
    EXPECT_EQ(pose.doubt, "");
    EXPECT_GT(pose.agreeing, 0.7);
    EXPECT_GE(pose.neighbours, 3);
  }
}

TEST(PoseRefinement, DoesNotDependOnTheOrderOfViews) {
  const std::vector<BoxBayView> how = test::twelve_views();
  const std::vector<MapView> views = seen(how);
  std::vector<std::size_t> order(views.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random(3);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<MapView> shuffled;
  for (const std::size_t i : order) shuffled.push_back(views[i]);
  const std::vector<RefinedPose> poses = refine_poses(views, {});
  const std::vector<RefinedPose> others = refine_poses(shuffled, {});
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_LT(test::error_of(others[i].foot_from_camera, poses[order[i]].foot_from_camera).mm, 1e-3);
}

TEST(PoseRefinement, LeavesAloneAViewThatSharesNothing) {
  std::vector<BoxBayView> how = test::twelve_views();
  how.resize(2);
  how.push_back({{0.0, 0.0}, {0.1, 0.1}, 0.05, 99});
  std::vector<MapView> views = seen(how);
  views[2].depth.disparity_px = Image<float>(424, 240);  // blind
  const std::vector<RefinedPose> poses = refine_poses(views, {});
  EXPECT_THAT(poses[2].doubt, HasSubstr("shares no surface"));
  EXPECT_TRUE(poses[2].foot_from_camera.isApprox(foot_from_camera({}, how[2].joints)));
  EXPECT_EQ(poses[0].doubt, "");
}

TEST(PoseRefinement, DoubtsAViewOfAnotherBay) {
  const std::vector<BoxBayView> how = test::twelve_views();
  std::vector<MapView> views = seen(how);
  test::Room other;
  other.boxes = {test::box(-1.0, 1.0, -1.0, 1.0, 0.5, 0.6)};
  views[5] = test::box_bay_view(how[5], {}, other);
  const std::vector<RefinedPose> poses = refine_poses(views, {});
  EXPECT_THAT(poses[5].doubt, HasSubstr("lies on the same surfaces"));
  EXPECT_TRUE(poses[5].foot_from_camera.isApprox(foot_from_camera({}, how[5].joints)));
}

TEST(PoseRefinement, OfOneViewIsWhatTheJointsSay) {
  const std::vector<BoxBayView> how{{{10.0, -20.0}, {0.1, 0.0}, 0.05, 1}};
  const std::vector<RefinedPose> poses = refine_poses(seen(how), {});
  EXPECT_TRUE(poses[0].foot_from_camera.isApprox(foot_from_camera({}, how[0].joints)));
}

}  // namespace
}  // namespace rva
