#include "map/map_files.hpp"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "map/view_folder.hpp"
#include "tests/map/box_bay.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using ColoredCloud = pcl::PointCloud<pcl::PointXYZRGB>;

std::vector<MapPoint> some_points() {
  return {{{0.1F, -0.2F, 0.3F}, {1, 2, 3}, 1}, {{-4.0F, 5.5F, 1e-4F}, {255, 0, 128}, 7}};
}

void expect_same(const ColoredCloud& read, const std::vector<MapPoint>& points) {
  ASSERT_EQ(read.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(read[i].getVector3fMap(), points[i].position_m);
    EXPECT_EQ((Rgb{read[i].r, read[i].g, read[i].b}), points[i].color);
  }
}

class MapFilesTest : public testing::Test {
 protected:
  MapFilesTest() {
    for (const test::BoxBayView& how :
         {test::BoxBayView{{5.0, -20.0}, {}, 0.0, 1}, {{9.0, -20.0}, {}, 0.0, 2}}) {
      views_.push_back(test::box_bay_view(how));
      RefinedPose pose;
      pose.foot_from_camera = foot_from_camera({}, {how.joints.pan_deg + 0.1, how.joints.tilt_deg});
      pose.turned_deg = 0.1;
      poses_.poses.push_back(pose);
    }
    poses_.base = "here";
    poses_.refined = true;
    poses_.poses[1].doubt = "too few common samples";
  }
  void write() { write_map(map_files(folder_ / "map.ply"), some_points(), views_, poses_); }

  test::TemporaryFolder folder_;
  std::vector<MapView> views_;
  MapPoses poses_;
};

TEST_F(MapFilesTest, PointsAreReadBack) {
  write();
  ColoredCloud ply;
  ColoredCloud pcd;
  ASSERT_EQ(pcl::io::loadPLYFile((folder_ / "map.ply").native(), ply), 0);
  ASSERT_EQ(pcl::io::loadPCDFile((folder_ / "map.pcd").native(), pcd), 0);
  expect_same(ply, some_points());
  expect_same(pcd, some_points());
}

TEST_F(MapFilesTest, PosesSayWhereEachViewWasTaken) {
  write();
  const auto json = nlohmann::json::parse(read_text_file(folder_ / "map.json"));
  EXPECT_EQ(json["format"], "rva-map");
  EXPECT_EQ(json["base"], "here");
  EXPECT_EQ(json["points"], 2);
  EXPECT_EQ(json["parameters"]["voxel_mm"], 3.0);
  EXPECT_EQ(json["geometry"]["servo1"]["at_m"][2], 0.18);
  ASSERT_EQ(json["views"].size(), 2U);
  const auto numbers = json["views"][0]["foot_from_camera"].get<std::array<double, 16>>();
  EXPECT_TRUE(from_row_major(numbers).isApprox(poses_.poses[0].foot_from_camera, 1e-12));
  const auto by_joints = json["views"][0]["foot_from_camera_by_joints"].get<std::array<double, 16>>();
  EXPECT_TRUE(from_row_major(by_joints).isApprox(foot_from_camera({}, {5.0, -20.0}), 1e-12));
  EXPECT_FALSE(json["views"][0].contains("doubt"));
  EXPECT_EQ(json["views"][1]["doubt"], "too few common samples");
}

TEST_F(MapFilesTest, WithoutRefinementSaysNothingOfIt) {
  poses_.refined = false;
  write();
  const auto json = nlohmann::json::parse(read_text_file(folder_ / "map.json"));
  EXPECT_FALSE(json["views"][0].contains("agreeing"));
}

TEST_F(MapFilesTest, LeaveNothingBeside) {
  write();
  write();  // in the place of the first
  const std::filesystem::directory_iterator files(folder_.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 3);
}

// Every state that a kill between two steps can leave.
TEST_F(MapFilesTest, AreCompletedAfterAKillAtAnyStep) {
  write();
  const MapFiles files = map_files(folder_ / "map.ply");
  const fs::path earlier = files.commit / "earlier.views";
  for (int done = 0; done <= 5; ++done) {
    fs::create_directories(files.commit);
    fs::create_directories(done >= 1 ? earlier : files.views);
    fs::create_directories(done >= 2 ? files.views : next_views(files.views));
    write_file((done >= 2 ? files.views : next_views(files.views)) / "new", "");
    const std::vector<std::pair<const char*, fs::path>> parts{
        {"json", files.poses}, {"pcd", files.pcd}, {"ply", files.ply}};
    for (int i = 0; i < 3; ++i) {
      const auto& [part, file] = parts[static_cast<std::size_t>(i)];
      write_file(file, done >= 3 + i ? "new" : "old");
      if (done < 3 + i) write_file(files.commit / part, "new");
    }
    finish_map(files);
    EXPECT_TRUE(fs::exists(files.views / "new")) << done;
    for (const auto& [part, file] : parts) EXPECT_EQ(read_text_file(file), "new") << done;
    EXPECT_FALSE(fs::exists(files.commit)) << done;
    EXPECT_FALSE(fs::exists(next_views(files.views))) << done;
    fs::remove_all(files.views);
  }
}

TEST_F(MapFilesTest, AFolderOfSomebodyElseIsNotTakenForAMap) {
  const MapFiles files = map_files(folder_ / "map.ply");
  fs::create_directories(files.commit);
  write_file(files.commit / "ply", "");
  write_file(files.commit / "notes.txt", "");
  finish_map(files);
  EXPECT_TRUE(fs::exists(files.commit / "ply"));
  EXPECT_THROW(write(), Error);
}

TEST_F(MapFilesTest, OnlyAnEarlierMapIsReplaced) {
  const MapFiles files = map_files(folder_ / "map.ply");
  require_replaceable(files, false);
  write();
  EXPECT_THROW(require_replaceable(files, false), Error);
  require_replaceable(files, true);
  std::filesystem::remove(files.ply);
  EXPECT_THROW(require_replaceable(files, false), Error) << "its poses are still there";
  write_file(files.poses, "{\"format\": \"rva-robot-geometry\"}");
  EXPECT_THROW(require_replaceable(files, true), Error);
  std::filesystem::remove(files.poses);
  EXPECT_THROW(require_replaceable(files, true), Error) << "a .pcd alone is no map of ours";
}

TEST_F(MapFilesTest, APathThatIsNoFolderIsAnError) {
  write_file(folder_ / "none", "a file");
  EXPECT_THROW(write_map(map_files(folder_ / "none" / "map.ply"), some_points(), views_, poses_), Error);
}

TEST(MapFiles, NeedANameThatEndsInPly) {
  EXPECT_EQ(map_files("a/map.ply").views, "a/map.views");
  for (const char* const name : {"map", "map.pcd", ".ply", ""})
    EXPECT_THROW((void)map_files(name), UsageError) << name;
}

}  // namespace
}  // namespace rva
