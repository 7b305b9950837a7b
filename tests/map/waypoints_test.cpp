#include "map/waypoints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Waypoints, OfAGridGoBackAndForth) {
  EXPECT_THAT(grid_waypoints({-10, 10, 3}, {-20, 0, 2}),
              ElementsAre(PanTilt{-10, -20}, PanTilt{0, -20}, PanTilt{10, -20}, PanTilt{10, 0}, PanTilt{0, 0},
                          PanTilt{-10, 0}));
  EXPECT_THAT(grid_waypoints({5, 80, 1}, {-20, 0, 1}), ElementsAre(PanTilt{5, -20}));
}

TEST(Waypoints, BeyondTheLimitsAreNamed) {
  check_waypoints({{-90, -90}, {90, 9}}, {});
  EXPECT_THAT(
      [] {
        check_waypoints({{0, 0}, {0, 9.5}}, {});
      },
      ThrowsMessage<UsageError>(testing::AllOf(HasSubstr("waypoint 2"), HasSubstr("tilt"))));
  EXPECT_THROW(check_waypoints({{std::numeric_limits<double>::quiet_NaN(), 0}}, {}), UsageError);
}

class WaypointFile : public testing::Test {
 protected:
  std::vector<PanTilt> load(const std::string& text) {
    write_file(folder_ / "w.json", text);
    return load_waypoints(folder_ / "w.json");
  }
  std::string complaint(const std::string& text) {
    try {
      (void)load(text);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
  static std::string list(const std::string& waypoints) {
    return R"({"format": "rva-waypoints", "version": 1, "waypoints": )" + waypoints + "}";
  }
  test::TemporaryFolder folder_;
};

TEST_F(WaypointFile, IsReadInItsOrder) {
  EXPECT_THAT(load(list(R"([{"pan_deg": 5, "tilt_deg": -3.5}, {"pan_deg": -80, "tilt_deg": 0}])")),
              ElementsAre(PanTilt{5, -3.5}, PanTilt{-80, 0}));
}

TEST_F(WaypointFile, ComplaintsNameTheField) {
  EXPECT_THAT(complaint("[]"), HasSubstr("not an object"));
  EXPECT_THAT(complaint("{}"), HasSubstr("not a list of waypoints"));
  EXPECT_THAT(complaint(R"({"format": "rva-waypoints", "version": 7})"), HasSubstr("version"));
  EXPECT_THAT(complaint(list("3")), HasSubstr("not a list"));
  EXPECT_THAT(complaint(list("[]")), HasSubstr("contains 0"));
  EXPECT_THAT(complaint(list(R"([{"pan_deg": 5, "tilt_deg": 0}, {"pan_deg": 5}])")),
              HasSubstr("waypoints[1].tilt_deg: missing"));
  EXPECT_THAT(complaint(list(R"([{"pan_deg": "left", "tilt_deg": 0}])")), HasSubstr("waypoints[0].pan_deg"));
  EXPECT_THROW((void)load_waypoints(folder_ / "none.json"), Error);
}

}  // namespace
}  // namespace rva
