#include "inspect/review_measurement.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/error.hpp"
#include "inspect/inspector.hpp"
#include "store/sqlite_records.hpp"
#include "tests/eventually.hpp"
#include "tests/inspect/waving_camera.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

/// A wall at 0.8 m on which a bump of 12 mm appeared, compared.
class Compared : public testing::Test {
 protected:
  Compared() {
    static_cast<void>(inspector_.begin({"N1", "bay 3", "WO", "Ann"}));
    take(Side::initial);
    plug_->bump_mm = 12;
    take(Side::final);
  }
  void take(Side side) {
    inspector_.capture(1, side, "Ann", false);
    ASSERT_TRUE(test::eventually([&] { return inspector_.task().end != TaskEnd::running; }));
    ASSERT_EQ(inspector_.task().end, TaskEnd::done) << inspector_.task().problem;
  }
  [[nodiscard]] MeasuredPicture picture(Side side, int view = 0) const {
    const Inspection inspection = inspector_.inspection(1);
    return measured_review(inspector_.folder(1), inspection, *inspection.comparison, view, side, options_);
  }
  [[nodiscard]] SurfacePoint point(Side side, const Eigen::Vector2d& pixel) const {
    return std::get<SurfacePoint>(picture(side).point(pixel, options_));
  }
  [[nodiscard]] MapMeasurement in_map(const std::array<Eigen::Vector3d, 2>& points_m,
                                      int comparison = 1) const {
    return measure_in_map(inspector_.folder(1), inspector_.inspection(1),
                          inspector_.comparison(1, comparison).value(), inspector_.chain(), points_m,
                          options_);
  }
  [[nodiscard]] Eigen::Vector3d in_foot_m(double u, double v, double depth_m) const {
    return foot_from_camera(inspector_.chain(), {}) *
           Eigen::Vector3d(depth_m * (u - 79.5) / 212.0, depth_m * (v - 59.5) / 212.0, depth_m);
  }

  MeasureOptions options_;
  test::TemporaryFolder folder_;
  std::shared_ptr<test::Plug> plug_ = std::make_shared<test::Plug>();
  LiveCamera camera_{std::make_unique<test::WavingCamera>(plug_), 1000.0};
  SqliteRecords records_{folder_ / "rva.db"};
  Inspector inspector_{InspectionRig{camera_}, records_, folder_.path(),
                       InspectorOptions{.frames = 16, .dither = 1, .readiness = {.least_free_gb = 0.0}}};
};

TEST_F(Compared, ThePicturesBeforeAndAfterHaveTheirOwnDepth) {
  EXPECT_NEAR(point(Side::final, {80, 60}).position_m.z(), 0.788, 0.001);
  EXPECT_NEAR(point(Side::initial, {80, 60}).position_m.z(), 0.800, 0.001);
  const auto wall = std::get<Plane>(
      plane_in(picture(Side::final).view,
               picture(Side::final).region({Eigen::Vector2d(10, 10), Eigen::Vector2d(150, 110)})));
  const Quantity height = height_above(point(Side::final, {80, 60}), wall, options_);
  EXPECT_NEAR(height.value_mm, 12.0, height.expanded_mm());
}

TEST_F(Compared, ViewsAndRoundsThatDoNotExistAreRefused) {
  EXPECT_THROW(static_cast<void>(picture(Side::final, 1)), Error);
  EXPECT_THROW(static_cast<void>(picture(Side::final, -1)), Error);
}

TEST_F(Compared, InTheMapTheSurfaceAtThePointsIsMeasured) {
  // Points of a map lie beside the surface, by up to half a voxel.
  const MapMeasurement measured = in_map({in_foot_m(20, 60, 0.801), in_foot_m(140, 60, 0.799)});
  ASSERT_TRUE(measured.length);
  EXPECT_NEAR(measured.length->value_mm, 800.0 * 120.0 / 212.0, measured.length->expanded_mm());
  EXPECT_NEAR((measured.points[0]->point.position_m - in_foot_m(20, 60, 0.8)).norm(), 0.0, 0.002);
  EXPECT_NEAR(measured.points[1]->distance.value_mm, 800.0 * std::hypot(1.0, 60.5 / 212.0, 0.5 / 212.0), 2.0);
}

TEST_F(Compared, TheMapOfAnEarlierRoundIsMeasuredByItsOwnCaptures) {
  plug_->bump_mm = 0;
  take(Side::final);
  const std::array bump{in_foot_m(80, 60, 0.788), in_foot_m(20, 60, 0.8)};
  EXPECT_TRUE(in_map(bump, 1).length);
  plug_->bump_mm = 100;
  take(Side::final);
  EXPECT_TRUE(in_map(bump, 2).length) << "12 mm from the surface of that round";
  EXPECT_FALSE(in_map(bump, 3).points[0]) << "the surface is 88 mm nearer";
  EXPECT_TRUE(in_map(bump, 1).length);
  RecordedComparison unknown = inspector_.comparison(1, 1).value();
  unknown.final_round = 0;
  EXPECT_THROW(static_cast<void>(measure_in_map(inspector_.folder(1), inspector_.inspection(1), unknown,
                                                inspector_.chain(), bump, options_)),
               Error);
}

TEST_F(Compared, PointsThatNoViewMeasuresAreRefused) {
  const MapMeasurement measured = in_map({in_foot_m(20, 60, 0.8), in_foot_m(140, 60, 0.7)});
  EXPECT_TRUE(measured.points[0]);
  EXPECT_FALSE(measured.points[1]) << "nothing is there";
  EXPECT_FALSE(measured.length);
  EXPECT_FALSE(in_map({in_foot_m(20, 60, 0.8), in_foot_m(500, 60, 0.8)}).points[1]) << "outside of the view";
}

}  // namespace
}  // namespace rva
