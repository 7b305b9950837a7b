#include "geometry/robot_geometry_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class RobotGeometryFile : public testing::Test {
 protected:
  // The error on loading a file with one value changed; empty where the file is accepted.
  std::string complaint(const std::string& pointer, const Json& value) {
    Json json = json_of(PanTiltChain{});
    json[Json::json_pointer(pointer)] = value;
    return complaint(json.dump());
  }
  std::string complaint(const std::string& text) {
    write_file(path_, text);
    try {
      (void)load_robot_geometry(path_);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "robot.json";
};

TEST_F(RobotGeometryFile, IsReadBackAsItWasWritten) {
  PanTiltChain chain;
  chain.servo1 = {{0.01, -0.02, 0.2}, Eigen::Vector3d(0.01, 0.02, 1.0).normalized()};
  chain.bracket = {{0.0, 0.003, 0.07}, Eigen::Vector3d(1.0, -0.03, 0.02).normalized()};
  chain.bracket_from_camera.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d(3.0, 2.0, 1.0).normalized()));
  write_file(path_, json_text(json_of(chain)));
  const PanTiltChain read = load_robot_geometry(path_);
  for (const PanTilt& joints : {PanTilt{0, 0}, PanTilt{-70, 5}, PanTilt{30, -60}})
    EXPECT_TRUE(foot_from_camera(read, joints).isApprox(foot_from_camera(chain, joints), 1e-12));
}

TEST_F(RobotGeometryFile, AxesRoundedByAPersonBecomeExact) {
  EXPECT_EQ(complaint("/servo1/axis", {0.0174, 0.0, 0.9998}), "");
  EXPECT_NEAR(load_robot_geometry(path_).servo1.axis.norm(), 1.0, 1e-15);
  EXPECT_EQ(complaint("/camera/forward", {0.0, 0.9996, 0.0}), "");
  EXPECT_TRUE(load_robot_geometry(path_).bracket_from_camera.linear().isUnitary(1e-14));
}

TEST_F(RobotGeometryFile, AnAxisWithoutUnitLengthIsRefused) {
  EXPECT_THAT(complaint("/bracket/axis", {2.0, 0.0, 0.0}), HasSubstr("bracket.axis: has length 2"));
  EXPECT_THAT(complaint("/servo1/axis", {0.0, 0.0, 0.0}), HasSubstr("servo1.axis: has length 0"));
  EXPECT_THAT(complaint("/camera/down", {0.0, 0.0, -1.01}), HasSubstr("camera.down: has length 1.01"));
}

TEST_F(RobotGeometryFile, ALeftHandedCameraIsRefused) {
  EXPECT_THAT(complaint("/camera/right", {-1.0, 0.0, 0.0}), HasSubstr("left-handed"));
}

TEST_F(RobotGeometryFile, AxesThatAreNotAtRightAnglesAreRefused) {
  EXPECT_THAT(complaint("/camera/right", {0.995, 0.0998, 0.0}), HasSubstr("right angles"));
}

TEST_F(RobotGeometryFile, ServosThatWouldTurnTheOtherWayAreRefused) {
  EXPECT_THAT(complaint("/servo1/axis", {0.0, 0.0, -1.0}), HasSubstr("servo1.axis: does not point up"));
  EXPECT_THAT(complaint("/bracket/axis", {-1.0, 0.0, 0.0}),
              HasSubstr("bracket.axis: does not point to the right"));
}

TEST_F(RobotGeometryFile, MillimetresAreRefused) {
  EXPECT_THAT(complaint("/servo1/at_m", {0.0, 0.0, 180.0}), HasSubstr("give metres"));
}

TEST_F(RobotGeometryFile, WhatIsNotAGeometryIsRefused) {
  EXPECT_THAT(complaint("{}"), HasSubstr("not a robot geometry"));
  EXPECT_THAT(complaint("servo1:"), HasSubstr("not JSON"));
  EXPECT_THAT(complaint("/version", 2), HasSubstr("version"));
  EXPECT_THAT(complaint("/camera/at_m", {0.0, 0.1}), HasSubstr("camera.at_m"));
  EXPECT_THAT(complaint("/camera/at_m", nullptr), HasSubstr("camera.at_m: missing"));
  EXPECT_THAT(complaint("/bracket", "here"), HasSubstr("bracket"));
}

}  // namespace
}  // namespace rva
