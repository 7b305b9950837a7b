#include "classify/finding_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace rva {
namespace {

constexpr int width = 200;
constexpr int height = 160;
constexpr float floor_m = 1.0F;
constexpr double fx = 100.0;    // 10 mm a pixel at the floor
const Box box{90, 70, 24, 24};  // so that its surroundings have as many pixels as a plane

CaptureInfo info() {
  CaptureInfo info;
  info.depth = Intrinsics{.width = width, .height = height, .fx = fx, .fy = fx, .cx = 100.0, .cy = 80.0};
  return info;
}

/// A block of 60 mm on a floor, as a finding.
struct Block {
  Detection detection;
  Finding finding;

  Block() {
    detection.initial_m = Image<float>(width, height, floor_m);
    detection.final_m = Image<float>(width, height, floor_m);
    finding.box = box;
    finding.position_m = {0.0, 0.0, 0.94};
    finding.size_mm = {240.0, 200.0};
    finding.top_above_surroundings_mm = 60.0;
    for (int v = box.y; v < box.y + box.height; ++v) {
      for (int u = box.x; u < box.x + box.width; ++u) {
        detection.final_m(u, v) = 0.94F;
        finding.pixels.push_back(static_cast<std::uint32_t>(v * width + u));
      }
    }
  }
};

float at(const cv::Mat& planes, FindingPlane plane, int row, int column) {
  return planes.ptr<float>(static_cast<int>(plane))[row * plane_px + column];
}

constexpr int middle = plane_px / 2;

TEST(FindingPlanes, ShowDepthOfTheFindingAndOfWhatIsAroundIt) {
  const Block block;
  const auto planes = planes_of(block.finding, block.detection, info(), {});
  ASSERT_TRUE(planes);
  constexpr float change = 60.0F / 80.0F;
  for (int row = 0; row < plane_px; ++row) {
    for (int column = 0; column < plane_px; ++column) {
      const bool inside = row >= 12 && row < 36 && column >= 12 && column < 36;
      EXPECT_EQ(at(*planes, FindingPlane::finding, row, column), inside ? 1.0F : 0.0F);
      EXPECT_NEAR(at(*planes, FindingPlane::change, row, column), inside ? change : 0.0F, 1e-4);
      EXPECT_NEAR(at(*planes, FindingPlane::shape, row, column), inside ? 0.0F : -change, 1e-4);
      EXPECT_EQ(at(*planes, FindingPlane::change_measured, row, column), 1.0F);
    }
  }
  EXPECT_NEAR(at(*planes, FindingPlane::height, 0, 0), change, 1e-4);
  EXPECT_NEAR(at(*planes, FindingPlane::long_side, 0, 0), std::log10(24.0), 1e-4);
  EXPECT_NEAR(at(*planes, FindingPlane::short_side, 0, 0), std::log10(20.0), 1e-4);
  EXPECT_NEAR(at(*planes, FindingPlane::scale, 0, 0), std::log10(9.4), 1e-4);
}

TEST(FindingPlanes, MarkWhatHasNoDepth) {
  Block block;
  block.detection.final_m(100, 80) = 0.0F;
  block.detection.initial_m(101, 80) = 0.0F;
  const auto planes = planes_of(block.finding, block.detection, info(), {});
  ASSERT_TRUE(planes);
  const int row = 80 - (box.y - 12);
  const int column = 100 - (box.x - 12);
  EXPECT_EQ(at(*planes, FindingPlane::shape_measured, row, column), 0.0F);
  EXPECT_EQ(at(*planes, FindingPlane::change_measured, row, column), 0.0F);
  EXPECT_EQ(at(*planes, FindingPlane::shape, row, column), 0.0F);
  EXPECT_EQ(at(*planes, FindingPlane::shape_measured, row, column + 1), 1.0F);
  EXPECT_EQ(at(*planes, FindingPlane::change_measured, row, column + 1), 0.0F);
}

TEST(FindingPlanes, ShowTheColorImageInItsOwnPixels) {
  const Block block;
  FindingPicture picture{ColorImage(2 * width, 2 * height, Rgb{51, 102, 255}), true};
  const auto planes = planes_of(block.finding, block.detection, info(), picture);
  ASSERT_TRUE(planes);
  EXPECT_NEAR(at(*planes, FindingPlane::red, middle, middle), 0.2, 1e-4);
  EXPECT_NEAR(at(*planes, FindingPlane::green, middle, middle), 0.4, 1e-4);
  EXPECT_NEAR(at(*planes, FindingPlane::blue, middle, middle), 1.0, 1e-4);
  EXPECT_EQ(at(*planes, FindingPlane::color, 0, 0), 1.0F);
  EXPECT_EQ(at(*planes, FindingPlane::infrared, 0, 0), 0.0F);
}

TEST(FindingPlanes, InfraredDoesNotDependOnItsExposure) {
  const Block block;
  Image<float> image(width, height, 40.0F);
  for (const std::uint32_t i : block.finding.pixels) image[i] = 60.0F;
  const auto dim = planes_of(block.finding, block.detection, info(), picture_of(image));
  for (float& pixel : image.pixels()) pixel *= 3.0F;
  const auto bright = planes_of(block.finding, block.detection, info(), picture_of(image));
  ASSERT_TRUE(dim && bright);
  EXPECT_NEAR(at(*dim, FindingPlane::red, middle, middle), 60.0 / (2.0 * 45.0), 1e-3);
  EXPECT_LT(cv::norm(*dim, *bright, cv::NORM_INF), 1e-4);
  EXPECT_EQ(at(*dim, FindingPlane::infrared, 0, 0), 1.0F);
}

TEST(FindingPlanes, OfADarkImageAreFinite) {
  const Block block;
  const auto planes =
      planes_of(block.finding, block.detection, info(), picture_of(Image<float>(width, height, 0.0F)));
  ASSERT_TRUE(planes);
  EXPECT_TRUE(cv::checkRange(*planes));
}

TEST(FindingPlanes, AtTheBorderAreOfTheNearestSquareWithin) {
  Block block;
  block.finding.box = {width - 10, height - 6, 10, 6};
  block.finding.pixels = {static_cast<std::uint32_t>(width * height - 1)};
  const auto planes = planes_of(block.finding, block.detection, info(), {});
  ASSERT_TRUE(planes);
  EXPECT_EQ(at(*planes, FindingPlane::finding, plane_px - 1, plane_px - 1), 1.0F);
}

TEST(FindingPlanes, OfAFindingWithoutAnyDepthHaveItsPosition) {
  Block block;
  for (const std::uint32_t i : block.finding.pixels) block.detection.final_m[i] = 0.0F;
  const auto planes = planes_of(block.finding, block.detection, info(), {});
  ASSERT_TRUE(planes);
  EXPECT_TRUE(cv::checkRange(*planes));
  EXPECT_EQ(at(*planes, FindingPlane::shape_measured, middle, middle), 0.0F);
}

TEST(FindingPlanes, AreNotMadeOfWhatIsNotThere) {
  Block removed;
  removed.finding.kind = ChangeKind::removed;
  EXPECT_FALSE(planes_of(removed.finding, removed.detection, info(), {}));
  Block nowhere;
  nowhere.finding.position_m.reset();
  EXPECT_FALSE(planes_of(nowhere.finding, nowhere.detection, info(), {}));
  Block without_size;
  without_size.finding.size_mm.reset();
  EXPECT_FALSE(planes_of(without_size.finding, without_size.detection, info(), {}));
}

TEST(FindingPlanes, AreWrittenAndReadAsNumPyFile) {
  const Block block;
  std::vector<cv::Mat> planes{*planes_of(block.finding, block.detection, info(), {})};
  planes.push_back(planes[0] + 1.0);
  std::string file = npy_of(planes);
  EXPECT_EQ(file.substr(1, 5), "NUMPY");
  const auto bytes = [&] { return std::as_bytes(std::span(file.data(), file.size())); };
  const auto halves = halves_in(bytes(), "shown.npy");
  ASSERT_EQ(halves.size(), 2U);
  std::vector<std::byte> copy(halves[1].begin(), halves[1].end());
  cv::Mat read;
  cv::Mat(planes[1].size.dims(), planes[1].size.p, CV_16F, copy.data()).convertTo(read, CV_32F);
  EXPECT_LT(cv::norm(read, planes[1], cv::NORM_INF), 1e-3);
  EXPECT_TRUE(halves_in(std::as_bytes(std::span<const char>(npy_of({}))), "shown.npy").empty());
  file.pop_back();
  EXPECT_THROW(static_cast<void>(halves_in(bytes(), "shown.npy")), Error);
  file.assign(20, ' ');
  EXPECT_THROW(static_cast<void>(halves_in(bytes(), "shown.npy")), Error);
}

}  // namespace
}  // namespace rva
