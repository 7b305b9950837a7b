#include "map/calibration_views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class CalibrationViews : public testing::Test {
 protected:
  void put(const char* name, const std::optional<std::string>& base, const std::string& serial = "1") {
    CaptureInfo info = test::info_of(8, 6);
    info.pose = Pose{base, 10.0, -20.0, {}};
    info.camera = CameraInfo{.model = "D435", .serial = serial};
    fs::create_directories(folder_ / name);
    CaptureWriter(folder_ / name, info).write_depth(0, DepthImage(8, 6, 1000));
    captures_.push_back(folder_ / name);
  }
  std::vector<MapView> load() { return load_calibration_views(captures_, {}); }

  test::TemporaryFolder folder_;
  std::vector<fs::path> captures_;
};

TEST_F(CalibrationViews, AreNamedByTheirPaths) {
  put("a", "here");
  put("b", "here");
  const std::vector<MapView> views = load();
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[1].name, (folder_ / "b").string());
  EXPECT_EQ(views[1].joints, (PanTilt{10.0, -20.0}));
}

TEST_F(CalibrationViews, AreOfOneBase) {
  put("a", "here");
  put("b", "elsewhere");
  EXPECT_THAT([&] { load(); }, ThrowsMessage<Error>(HasSubstr("same position")));
  captures_.clear();
  put("c", std::nullopt);
  EXPECT_THAT([&] { load(); }, ThrowsMessage<Error>(HasSubstr("pose.base")));
}

TEST_F(CalibrationViews, AreOfOneCamera) {
  put("a", "here");
  put("b", "here", "2");
  EXPECT_THAT([&] { load(); }, ThrowsMessage<Error>(HasSubstr("same camera")));
}

TEST_F(CalibrationViews, AreGivenOnce) {
  put("a", "here");
  captures_.push_back(folder_ / "." / "a");
  EXPECT_THAT([&] { load(); }, ThrowsMessage<Error>(HasSubstr("given twice")));
}

}  // namespace
}  // namespace rva
