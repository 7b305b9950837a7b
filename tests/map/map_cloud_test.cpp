#include "map/map_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "core/error.hpp"
#include "tests/map/box_bay.hpp"

namespace rva {
namespace {

using test::BoxBayView;

std::vector<Transform> poses_of(const std::vector<BoxBayView>& how) {
  std::vector<Transform> poses;
  for (const BoxBayView& view : how) poses.push_back(foot_from_camera({}, test::true_joints(view)));
  return poses;
}

// To the nearest face of a box, from outside or inside.
double distance_m(const test::Room& room, const Eigen::Vector3d& point) {
  double nearest = 1e9;
  for (const test::Box3& solid : room.boxes) {
    const double outside = solid.exteriorDistance(point);
    const double inside = std::min((point - solid.min()).minCoeff(), (solid.max() - point).minCoeff());
    nearest = std::min(nearest, outside > 0.0 ? outside : inside);
  }
  return nearest;
}

class MapCloud : public testing::Test {
 protected:
  MapCloud() {
    for (const BoxBayView& view : how_) views_.push_back(test::box_bay_view(view));
  }
  std::vector<BoxBayView> how_{{{-15, -20}, {}, 0.02, 1}, {{0, -25}, {}, 0.02, 2}, {{20, -20}, {}, 0.02, 3}};
  std::vector<MapView> views_;
};

TEST_F(MapCloud, LiesOnTheSurfaces) {
  const std::vector<MapPoint> points = join_views(views_, poses_of(how_), {});
  ASSERT_GT(points.size(), 10000U);
  double sum = 0.0;
  for (const MapPoint& point : points) {
    const double off_m = distance_m(test::bay(), test::room_from_foot() * point.position_m.cast<double>());
    sum += off_m * off_m;
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(points.size())), 0.002);
}

TEST_F(MapCloud, HasOnePointInEachCube) {
  MapCloudOptions options;
  options.voxel_mm = 20.0;
  std::set<std::tuple<int, int, int>> cubes;
  for (const MapPoint& point : join_views(views_, poses_of(how_), options)) {
    const Eigen::Vector3f cell = point.position_m / 0.02F;
    // The mean of points of a cube lies in it, but for what single precision rounds.
    cubes.insert({static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y())),
                  static_cast<int>(std::floor(cell.z()))});
    EXPECT_GE(point.views, 1);
    EXPECT_LE(point.views, 3);
  }
  EXPECT_GE(cubes.size() + 3, join_views(views_, poses_of(how_), options).size());
}

TEST_F(MapCloud, DoesNotDependOnTheOrderOfViews) {
  const std::vector<MapPoint> points = join_views(views_, poses_of(how_), {});
  std::swap(views_[0], views_[2]);
  std::swap(how_[0], how_[2]);
  const std::vector<MapPoint> others = join_views(views_, poses_of(how_), {});
  ASSERT_EQ(points.size(), others.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((points[i].position_m - others[i].position_m).norm(), 1e-6F);
}

TEST_F(MapCloud, LeavesOutWhatIsTooNearOrTooFar) {
  MapCloudOptions options;
  options.near_m = 0.5;
  options.far_m = 0.8;
  const std::vector<Transform> poses = poses_of(how_);
  const std::vector<MapView> one(views_.begin(), views_.begin() + 1);
  const std::vector<MapPoint> points = join_views(one, {poses.data(), 1}, options);
  ASSERT_FALSE(points.empty());
  for (const MapPoint& point : points) {
    const double z_m = (poses[0].inverse() * point.position_m.cast<double>()).z();
    EXPECT_GE(z_m, 0.5 - 1e-6);
    EXPECT_LE(z_m, 0.8 + 1e-6);
  }
}

TEST_F(MapCloud, WeighsNearViewsMore) {
  // One wall, which the nearer view puts where it is, the farther one 1 mm behind.
  MapView near = views_[0];
  MapView far = views_[0];
  for (MapView* const view : {&near, &far}) view->depth.disparity_px = Image<float>(424, 240);
  for (float& px : near.depth.disparity_px.pixels())
    px = static_cast<float>(near.depth.stereo.disparity_px(0.504));
  for (float& px : far.depth.disparity_px.pixels())
    px = static_cast<float>(far.depth.stereo.disparity_px(1.005));
  const std::vector<MapView> views{near, far};
  Transform behind = Transform::Identity();
  behind.translation().z() = -0.5;
  const std::vector<Transform> poses{Transform::Identity(), behind};
  MapCloudOptions options;
  options.voxel_mm = 10.0;
  int both = 0;
  float farthest_m = 0.0F;
  for (const MapPoint& point : join_views(views, poses, options)) {
    if (point.views != 2) continue;
    ++both;
    farthest_m = std::max(farthest_m, point.position_m.z());
  }
  EXPECT_GT(both, 100);
  EXPECT_LT(farthest_m, 0.5041F);  // not the middle, 0.5045
}

TEST_F(MapCloud, MatchesAtEdgesAndSpecksAreNoSupport) {
  DepthView view = views_[0].depth;
  view.disparity_px = Image<float>(424, 240);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 424; ++u) view.disparity_px(u, v) = u < 200 ? 10.0F : 20.0F;
  }
  view.disparity_px(100, 100) = 15.0F;
  const Mask good = supported(view);
  EXPECT_EQ(good(100, 100), 0);
  EXPECT_EQ(good(99, 100), mask_set);
  EXPECT_EQ(good(199, 50), 0);
  EXPECT_EQ(good(200, 50), 0);
  EXPECT_EQ(good(197, 50), mask_set);
  EXPECT_EQ(good(0, 50), 0);
}

TEST_F(MapCloud, TakesColourFromAnotherViewWhereItsOwnHasNone) {
  // All of the second view is red; the first one has no camera for colour.
  views_.resize(2);
  ViewColor red{ColorImage(424, 240, Rgb{200, 10, 20}), test::small_camera(), Transform::Identity()};
  views_[1].color = red;
  std::vector<Transform> poses = poses_of(how_);
  poses.resize(2);
  std::size_t grey = 0;
  std::size_t painted = 0;
  for (const MapPoint& point : join_views(views_, poses, {})) {
    const Eigen::Vector3d seen = poses[1].inverse() * point.position_m.cast<double>();
    const bool in_view = seen.z() > 0.0 && test::small_camera().contains(test::small_camera().project(seen));
    if (point.color == Rgb{200, 10, 20}) {
      ++painted;
      EXPECT_TRUE(in_view);
    } else {
      EXPECT_EQ(point.color, (Rgb{128, 128, 128}));
      ++grey;
    }
  }
  EXPECT_GT(painted, grey);
  EXPECT_GT(grey, 100U);
}

TEST_F(MapCloud, OptionsAreChecked) {
  MapCloudOptions options;
  options.voxel_mm = 0.0;
  EXPECT_THROW((void)join_views(views_, poses_of(how_), options), Error);
}

}  // namespace
}  // namespace rva
