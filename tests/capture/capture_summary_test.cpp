#include "capture/capture_summary.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

TEST(CaptureSummary, IsOfAllFrames) {
  std::vector<DepthImage> frames{DepthImage(4, 3, 1000), DepthImage(4, 3, no_depth)};
  frames[1](0, 0) = 700;
  frames[1](3, 2) = 2500;
  frames[1](1, 1) = 1200;
  CaptureInfo info = test::info_of(4, 3);
  info.depth_unit_m = 0.0005;
  info.notes = {"the unit is assumed"};
  const CaptureSummary summary = summarize(test::MemoryCapture(info, frames), {});
  EXPECT_DOUBLE_EQ(summary.fill_rate, 15.0 / 24.0);
  EXPECT_DOUBLE_EQ(summary.nearest_m, 0.35);
  EXPECT_DOUBLE_EQ(summary.farthest_m, 1.25);
  EXPECT_EQ(summary.lost, 0U);
  EXPECT_EQ(summary.notes, info.notes);
}

TEST(CaptureSummary, IsZeroWhereNothingWasMeasured) {
  const CaptureSummary summary = summarize(test::capture_of({DepthImage(4, 3, no_depth)}), {});
  EXPECT_EQ(summary.fill_rate, 0.0);
  EXPECT_EQ(summary.nearest_m, 0.0);
  EXPECT_EQ(summary.farthest_m, 0.0);
}

/// Its colour image is damaged.
class DamagedColor : public test::MemoryCapture {
 public:
  using MemoryCapture::MemoryCapture;
  [[nodiscard]] std::size_t color_frames() const override { return 1; }
  [[nodiscard]] ColorImage color(std::size_t /*i*/) const override {
    throw Error("color/000000.png", "damaged", "record it again");
  }
};

TEST(CaptureSummary, NeedsEveryColourImage) {
  const DamagedColor capture(test::info_of(4, 3), {DepthImage(4, 3, 1000)});
  EXPECT_THROW(static_cast<void>(summarize(capture, {})), Error);
}

}  // namespace
}  // namespace rva
