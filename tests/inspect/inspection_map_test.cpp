#include "inspect/inspection_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr int width = 64;
constexpr int height = 48;
const Intrinsics camera{width, height, 60.0, 60.0, 31.5, 23.5};
constexpr double unit_m = 0.0001;

Transform somewhere() {
  Transform map_from_camera(Eigen::Translation3d(0.3, -0.2, 0.5));
  map_from_camera.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  return map_from_camera;
}

TEST(MapFromCamera, IsThePoseOfTheCaptureOrThatOfARestingRobot) {
  const PanTiltChain chain;
  CaptureInfo info;
  const Transform resting = map_from_camera(info, chain);
  EXPECT_TRUE((resting.linear() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitY(), 1e-12))
      << "it looks forward";
  EXPECT_GT(resting.translation().z(), 0.2) << "above the foot";
  info.pose = Pose{};
  EXPECT_TRUE(map_from_camera(info, chain).isApprox(resting)) << "a pose that states a base alone";
  info.pose->world_from_camera = somewhere();
  EXPECT_TRUE(map_from_camera(info, chain).isApprox(somewhere()));
}

TEST(ChangedPoints, LieOnTheRaysOfTheirPixels) {
  Detection detection;
  detection.final_m = Image<float>(width, height);
  ColorImage picture(width, height);
  std::vector<std::uint32_t> pixels;
  for (const auto& [u, v] : {std::pair{0, 0}, {63, 0}, {10, 47}, {63, 47}, {31, 20}}) {
    detection.final_m(u, v) = 0.5F + 0.01F * static_cast<float>(u);
    picture(u, v) = {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v), 7};
    pixels.push_back(static_cast<std::uint32_t>(v * width + u));
  }
  pixels.push_back(5 * width + 5);  // without depth
  detection.findings.findings.resize(2);
  detection.findings.findings[0].pixels = {pixels.begin(), pixels.begin() + 2};
  detection.findings.findings[1].pixels = {pixels.begin() + 2, pixels.end()};
  const std::vector<MapPoint> points = changed_points(detection, picture, camera, somewhere());
  ASSERT_EQ(points.size(), 5U);
  for (const MapPoint& point : points) {
    const Eigen::Vector3d in_camera = somewhere().inverse() * point.position_m.cast<double>();
    const Eigen::Vector2d pixel = camera.project(in_camera);
    EXPECT_NEAR(pixel.x(), point.color.r, 1e-3);
    EXPECT_NEAR(pixel.y(), point.color.g, 1e-3);
    EXPECT_NEAR(in_camera.z(), 0.5 + 0.01 * point.color.r, 1e-5);
    EXPECT_EQ(point.views, 1);
  }
  EXPECT_TRUE(changed_points(Detection{}, picture, camera, somewhere()).empty());
}

/// Positions in a file as write_inspection_map() writes it.
std::vector<Eigen::Vector3f> points_in(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  std::string line;
  std::size_t count = 0;
  while (std::getline(input, line) && line != "end_header")
    if (line.starts_with("element vertex ")) count = std::stoul(line.substr(15));
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, 15> bytes{};
    input.read(bytes.data(), bytes.size());
    std::array<float, 3> position_m{};
    std::memcpy(position_m.data(), bytes.data(), sizeof(position_m));
    points.emplace_back(position_m[0], position_m[1], position_m[2]);
  }
  EXPECT_TRUE(input.good());
  EXPECT_EQ(input.peek(), std::ifstream::traits_type::eof());
  return points;
}

class InspectionMapTest : public testing::Test {
 protected:
  /// A flat wall before the camera.
  void put(int view, double depth_m, const std::optional<Transform>& pose) {
    CaptureInfo info;
    info.depth = camera;
    info.depth_unit_m = unit_m;
    info.camera = CameraInfo{"", "", 0.05};
    if (pose) info.pose = Pose{std::nullopt, std::nullopt, std::nullopt, pose};
    const std::filesystem::path path = folder_.capture(Side::final, inspection_, view, 0);
    std::filesystem::create_directories(path);
    CaptureWriter writer(path, info);
    for (std::size_t frame = 0; frame < 2; ++frame)
      writer.write_depth(frame, DepthImage(width, height, static_cast<std::uint16_t>(depth_m / unit_m)));
  }
  void write() { write_inspection_map(file_, folder_, inspection_, false, chain_); }

  test::TemporaryFolder data_;
  InspectionFolder folder_{data_.path(), 1};
  std::filesystem::path file_ = data_ / "map.ply";
  Inspection inspection_ = [] {
    Inspection inspection;
    inspection.views = {{0, 0}};
    return inspection;
  }();
  PanTiltChain chain_;
};

TEST_F(InspectionMapTest, OfACameraThatStandsStillIsInFrontOfIt) {
  put(0, 0.8, std::nullopt);
  write();
  const std::vector<Eigen::Vector3f> points = points_in(file_);
  EXPECT_GT(points.size(), 500U);
  const double camera_y_m = map_from_camera({}, chain_).translation().y();
  for (const Eigen::Vector3f& point : points) EXPECT_NEAR(point.y(), camera_y_m + 0.8, 1e-3);
}

TEST_F(InspectionMapTest, JoinsAllViewsAtTheirPoses) {
  inspection_.views = {{0, 0}, {10, 0}};
  Transform other = Transform::Identity();
  other.translation() = Eigen::Vector3d(3.0, 0.0, 0.0);
  put(0, 0.8, Transform::Identity());
  put(1, 1.2, other);
  write();
  std::size_t near = 0;
  std::size_t far = 0;
  for (const Eigen::Vector3f& point : points_in(file_)) {
    if (std::abs(point.z() - 0.8F) < 1e-3F && point.x() < 1.0F) ++near;
    if (std::abs(point.z() - 1.2F) < 1e-3F && point.x() > 2.0F) ++far;
  }
  EXPECT_GT(near, 500U);
  EXPECT_GT(far, 500U);
  EXPECT_EQ(near + far, points_in(file_).size());
}

TEST_F(InspectionMapTest, NeedsEveryCapture) {
  inspection_.views = {{0, 0}, {10, 0}};
  put(0, 0.8, std::nullopt);
  try {
    write();
    ADD_FAILURE() << "a view is missing";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("final/001"));
  }
  EXPECT_FALSE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace rva
