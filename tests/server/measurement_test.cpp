#include "server/measurement.hpp"

#include <gtest/gtest.h>

#include "server/api.hpp"

namespace rva {
namespace {

// A wall at one metre.
std::shared_ptr<LiveFrame> wall() {
  auto live = std::make_shared<LiveFrame>();
  live->info.depth = {160, 120, 200.0, 200.0, 79.5, 59.5};
  live->info.depth_unit_m = 0.001;
  live->info.camera = CameraInfo{"wall", "1", 0.05};
  live->frame.depth = DepthImage(160, 120, 1000);
  return live;
}

Json measured(const std::shared_ptr<const LiveFrame>& live, const char* body) {
  return measure(measured_picture({&live, 1}, Stream::depth, {}), measure_request_in(Json::parse(body)), {});
}

TEST(Measurement, ADistanceIsAlongTheLineOfSight) {
  const Json answer = measured(wall(), R"({"points": [{"u": 119.5, "v": 59.5}]})");
  EXPECT_EQ(answer["tool"], "distance");
  EXPECT_EQ(answer["coverage_factor"], 2.0);
  EXPECT_NEAR(answer["points"][0]["distance_m"].get<double>(), std::hypot(1.0, 0.2), 1e-6);
  // By (2), half a per cent of scale, and twice the whole.
  EXPECT_GT(answer["points"][0]["distance_uncertainty_mm"].get<double>(), 2.0 * 0.005 * 1000.0);
  EXPECT_FALSE(answer["points"][0]["near_edge"]);
  EXPECT_FALSE(answer.contains("length_mm"));
}

TEST(Measurement, ALengthIsOfSpaceNotOfTheImage) {
  const Json answer = measured(wall(), R"({"points": [{"u": 40, "v": 60}, {"u": 120, "v": 60}]})");
  EXPECT_EQ(answer["tool"], "length");
  EXPECT_NEAR(answer["length_mm"].get<double>(), 1000.0 * 80.0 / 200.0, 1e-3);
  EXPECT_GT(answer["length_uncertainty_mm"].get<double>(), 2.0 * 0.005 * 400.0);
}

TEST(Measurement, AHeightIsAboveThreePointsOrARegion) {
  auto live = wall();
  for (int v = 55; v < 70; ++v) {
    for (int u = 75; u < 90; ++u) live->frame.depth(u, v) = 970;
  }
  const Json by_points =
      measured(live, R"({"tool": "height", "points": [{"u": 20, "v": 20}, {"u": 140, "v": 20},
                                            {"u": 80, "v": 110}, {"u": 82, "v": 62}]})");
  EXPECT_NEAR(by_points["height_mm"].get<double>(), 30.0, 1e-3);
  EXPECT_FALSE(by_points.contains("length_mm"));
  const Json by_region =
      measured(live, R"({"tool": "height", "points": [{"u": 82, "v": 62}], "bbox": [50, 30, 60, 60]})");
  EXPECT_NEAR(by_region["height_mm"].get<double>(), 30.0, 1e-3);
  EXPECT_LT(by_region["height_uncertainty_mm"].get<double>(),
            by_points["height_uncertainty_mm"].get<double>())
      << "many pixels determine a plane better than three";
}

TEST(Measurement, AProfileStatesItsGaps) {
  auto live = wall();
  for (int v = 55; v < 66; ++v) {
    for (int u = 75; u < 90; ++u) live->frame.depth(u, v) = no_depth;
  }
  const Json answer =
      measured(live, R"({"tool": "profile", "points": [{"u": 40, "v": 60}, {"u": 120, "v": 60}]})");
  ASSERT_EQ(answer["profile"].size(), 81U);
  EXPECT_FALSE(answer["profile"][42].contains("height_mm")) << "no depth there";
  EXPECT_NEAR(answer["profile"][20]["height_mm"].get<double>(), 0.0, 1e-3);
  EXPECT_NEAR(answer["profile"][20]["along_mm"].get<double>(), 100.0, 1e-2);
}

TEST(Measurement, WhatCannotBeMeasuredIsExplained) {
  auto live = wall();
  for (int v = 50; v < 70; ++v) {
    for (int u = 70; u < 90; ++u) live->frame.depth(u, v) = no_depth;
  }
  const Json hole = measured(live, R"({"points": [{"u": 20, "v": 20}, {"u": 80, "v": 60}]})");
  EXPECT_EQ(hole["problem"], "no depth is measured at point 2");
  EXPECT_EQ(hole["unmeasured"], Json::parse(R"({"reason": "no-depth", "part": "point", "point": 2})"));
  EXPECT_TRUE(hole["points"][1].is_null());
  EXPECT_FALSE(hole.contains("length_mm"));
  EXPECT_EQ(measured(live, R"({"points": [{"u": -5, "v": 60}]})")["problem"],
            "point 1 is outside of the depth image");
  const Json line = measured(live, R"({"tool": "height", "points": [{"u": 20, "v": 20}, {"u": 40, "v": 20},
                                       {"u": 60, "v": 20}, {"u": 100, "v": 80}]})");
  EXPECT_NE(line["problem"].get<std::string>().find("span no plane"), std::string::npos);
  EXPECT_EQ(line["unmeasured"], Json::parse(R"({"reason": "collinear", "part": "surface-points"})"));
}

TEST(Measurement, MoreFramesReduceTheUncertainty) {
  std::vector<std::shared_ptr<const LiveFrame>> frames;
  for (int i = 0; i < 8; ++i) frames.push_back(wall());
  const MeasureRequest request = measure_request_in(Json::parse(R"({"points": [{"u": 80, "v": 60}]})"));
  MeasureOptions options;
  options.frame_px = 0.5;
  const auto uncertainty = [&](std::size_t count) {
    const Json answer =
        measure(measured_picture({frames.data(), count}, Stream::depth, options), request, options);
    return answer["points"][0]["distance_uncertainty_mm"].get<double>();
  };
  EXPECT_LT(uncertainty(8), uncertainty(1));
}

TEST(Measurement, ColourIsRefusedWhereItsImagerIsUnknown) {
  auto live = wall();
  live->info.color = live->info.depth;
  EXPECT_FALSE(is_measurable(live->info, Stream::color));
  EXPECT_TRUE(is_measurable(live->info, Stream::infrared));
  const std::shared_ptr<const LiveFrame> frame = live;
  EXPECT_THROW(static_cast<void>(measured_picture({&frame, 1}, Stream::color, {})), Error);
}

TEST(Measurement, MalformedRequestsAreRefused) {
  for (const char* const body :
       {R"({})", R"({"points": []})", R"({"points": 7})", R"({"points": [{"u": 1}]})",
        R"({"points": [{"u": 1, "v": 1}], "tool": "volume"})",
        R"({"points": [{"u": 1, "v": 1}], "tool": "length"})",
        R"({"points": [{"u": 1, "v": 1}], "tool": "height", "bbox": [1, 2, 3]})",
        R"({"points": [{"u": 1, "v": 1}, {"u": 1, "v": 1}, {"u": 1, "v": 1}]})"})
    EXPECT_THROW(static_cast<void>(measure_request_in(Json::parse(body))), ApiError) << body;
}

}  // namespace
}  // namespace rva
