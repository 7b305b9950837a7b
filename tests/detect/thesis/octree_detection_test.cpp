#include "detect/thesis/octree_detection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/error.hpp"
#include "detect/thesis/octree_change.hpp"
#include "tests/views/shots.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::shoot;
using testing::ElementsAre;
using testing::IsEmpty;

PointCloud cloud_of(std::initializer_list<Eigen::Vector3f> points_m) {
  PointCloud cloud{points_m, {}};
  cloud.pixels.resize(cloud.points_m.size());
  std::iota(cloud.pixels.begin(), cloud.pixels.end(), 0U);
  return cloud;
}

// A room as seen, thinned, so that a step takes little.
PointCloud points_of(const Transform& at) {
  const auto capture = shoot(bay(), {at, std::nullopt, 1});
  const Eigen::AlignedBox3f box{Eigen::Vector3f::Constant(-10), Eigen::Vector3f::Constant(10)};
  const PointCloud all = deproject(capture->depth(0), capture->info().depth, test::unit_m, box);
  PointCloud thinned;
  for (std::size_t i = 0; i < all.points_m.size(); i += 7) {
    thinned.points_m.push_back(all.points_m[i]);
    thinned.pixels.push_back(all.pixels[i]);
  }
  return thinned;
}

TEST(OctreeChange, FindsPointsInCellsThatWereEmpty) {
  const PointCloud before = cloud_of({{0.0F, 0.0F, 1.0F}, {0.3F, 0.0F, 1.0F}, {0.0F, 0.3F, 1.2F}});
  const PointCloud after =
      cloud_of({{0.0F, 0.0F, 1.0F}, {0.3F, 0.2F, 1.0F}, {0.0F, 0.3F, 1.2F}, {-0.2F, 0.0F, 1.0F}});
  EXPECT_THAT(points_in_new_cells(before, before, Transform::Identity(), 0.05), IsEmpty());
  EXPECT_THAT(points_in_new_cells(before, after, Transform::Identity(), 0.05), ElementsAre(1, 3));
}

TEST(OctreeChange, MissesWhatLiesInTheCellsOfWhatWasThere) {
  const PointCloud before = cloud_of({{0.0F, 0.0F, 1.0F}, {0.3F, 0.0F, 1.0F}});
  const PointCloud after = cloud_of({{0.0F, 0.0F, 1.0F}, {0.3F, 0.0F, 1.0F}, {0.001F, 0.0F, 1.0F}});
  EXPECT_THAT(points_in_new_cells(before, after, Transform::Identity(), 0.05), IsEmpty());
}

TEST(OctreeChange, LaysTheInitialCloudOverTheFinalOne) {
  const Transform final_from_initial(Eigen::Translation3d(0.0, 0.0, 0.5));
  const PointCloud before = cloud_of({{0.0F, 0.0F, 1.0F}});
  const PointCloud after = cloud_of({{0.0F, 0.0F, 1.5F}, {0.0F, 0.0F, 1.0F}});
  EXPECT_THAT(points_in_new_cells(before, after, final_from_initial, 0.05), ElementsAre(1));
}

TEST(IncrementalIcp, EndsNearerThanItBegan) {
  const Transform initial = pose(0.02, 0.0, -1.0);
  const Transform final = pose(0.0, 0.01, 0.5);
  const Transform truth = final.inverse() * initial;
  const test::PoseError start = test::error_of(Transform::Identity(), truth);
  const test::PoseError end = test::error_of(
      register_incrementally(points_of(initial), points_of(final), {20, 0.05}, Progress()), truth);
  EXPECT_LT(end.mm, 0.5 * start.mm);
  EXPECT_LT(end.deg, 0.7 * start.deg);
}

TEST(IncrementalIcp, RefusesCloudsFarFromEachOther) {
  const PointCloud here = cloud_of({{0.0F, 0.0F, 1.0F}, {0.1F, 0.0F, 1.0F}, {0.0F, 0.1F, 1.0F}});
  const PointCloud there = cloud_of({{5.0F, 0.0F, 1.0F}, {5.1F, 0.0F, 1.0F}, {5.0F, 0.1F, 1.0F}});
  EXPECT_THROW((void)register_incrementally(here, there, {}, Progress()), Error);
}

TEST(OctreeDetection, FindsABoxInFreeSpaceAndNothingWithout) {
  OctreeOptions options;
  options.icp.iterations = 2;
  const Transform at = pose(0.0, 0.0, 0.0);
  test::Room with = bay();
  with.boxes.push_back(test::box(-0.06, 0.06, 0.05, 0.25, 0.65, 0.75));
  const auto before = shoot(bay(), {at, std::nullopt, 1});
  const Detection none =
      detect_by_octree(*before, *shoot(bay(), {at, std::nullopt, 2}), options, {}, Progress());
  std::size_t of_edges = 0;  // cells that a point of noise alone fills
  for (const Finding& finding : none.findings.findings) of_edges = std::max(of_edges, finding.pixels.size());
  EXPECT_LT(of_edges, 200U);
  const Detection found =
      detect_by_octree(*before, *shoot(with, {at, std::nullopt, 3}), options, {}, Progress());
  ASSERT_FALSE(found.findings.findings.empty());
  EXPECT_GT(found.findings.findings.front().pixels.size(), 500U);
  EXPECT_EQ(found.findings.findings.front().kind, ChangeKind::added);
  const Coverage& coverage = found.findings.coverage;
  EXPECT_NEAR(coverage.compared + coverage.unseen + coverage.invalid + coverage.beyond_clip.value(), 1.0,
              1e-9);
}

TEST(OctreeDetection, RefusesWhatLeavesNoPoint) {
  OctreeOptions options;
  options.far_m = 0.05;
  const auto capture = shoot(bay(), {});
  EXPECT_THROW((void)detect_by_octree(*capture, *capture, options, {}, Progress()), Error);
  options.cell_m = 0.0;
  EXPECT_THROW((void)detect_by_octree(*capture, *capture, options, {}, Progress()), UsageError);
}

}  // namespace
}  // namespace rva
