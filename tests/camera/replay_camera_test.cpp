#include "camera/replay_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/manual_clock.hpp"

namespace rva {
namespace {

/// Three frames whose pixels contain their number, the first with colour; the one named may be damaged.
class NumberedCapture : public Capture {
 public:
  explicit NumberedCapture(std::optional<std::size_t> damaged = {})
      : Capture(test::info_of(4, 3)), damaged_(damaged) {}
  [[nodiscard]] std::size_t depth_frames() const override { return 3; }
  [[nodiscard]] std::size_t color_frames() const override { return 1; }
  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    if (i == damaged_) throw Error("frame", "damaged", "record it again");
    return {4, 3, static_cast<std::uint16_t>(100 + i)};
  }
  [[nodiscard]] ColorImage color(std::size_t /*i*/) const override { return {4, 3, Rgb{1, 2, 3}}; }

 private:
  std::optional<std::size_t> damaged_;
};

class Replay : public testing::Test {
 protected:
  ReplayCamera camera(const ReplayOptions& options) {
    return ReplayCamera(std::make_unique<NumberedCapture>(), options, clock_.clock());
  }
  test::ManualClock clock_;
};

TEST_F(Replay, GivesEveryFrameInOrderAndEnds) {
  ReplayCamera replay = camera({.rate_hz = 10.0});
  for (std::uint64_t k = 0; k < 3; ++k) {
    const auto frame = replay.wait_for_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->depth, DepthImage(4, 3, static_cast<std::uint16_t>(100 + k)));
    EXPECT_EQ(frame->color.has_value(), k == 0);
    EXPECT_EQ(frame->number, k);
    EXPECT_DOUBLE_EQ(frame->time_s, 0.1 * static_cast<double>(k));
  }
  EXPECT_FALSE(replay.wait_for_frame());
  EXPECT_FALSE(replay.wait_for_frame());
}

TEST_F(Replay, DescribesItsCapture) { EXPECT_EQ(camera({}).info().depth, test::info_of(4, 3).depth); }

TEST_F(Replay, LoopsWithoutEnd) {
  ReplayCamera replay = camera({.loop = true});
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto frame = replay.wait_for_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->depth[0], 100 + k % 3);
    EXPECT_EQ(frame->number, k);
  }
}

TEST_F(Replay, KeepsItsRate) {
  ReplayCamera replay = camera({.rate_hz = 5.0, .loop = true});
  const double start_s = clock_.now_s;
  for (int k = 0; k < 11; ++k) {
    static_cast<void>(replay.wait_for_frame());
    EXPECT_NEAR(clock_.now_s - start_s, 0.2 * k, 1e-9);
  }
}

TEST_F(Replay, ALateFrameComesAtOnceAndTheRateGoesOnFromThere) {
  ReplayCamera replay = camera({.rate_hz = 5.0, .loop = true});
  static_cast<void>(replay.wait_for_frame());
  clock_.now_s += 10.0;
  const double late_s = clock_.now_s;
  static_cast<void>(replay.wait_for_frame());
  EXPECT_EQ(clock_.now_s, late_s);
  for (int k = 1; k < 6; ++k) {
    static_cast<void>(replay.wait_for_frame());
    EXPECT_NEAR(clock_.now_s - late_s, 0.2 * k, 1e-9);
  }
}

TEST_F(Replay, ShortDelaysDoNotAddUp) {
  ReplayCamera replay = camera({.rate_hz = 5.0, .loop = true});
  const double start_s = clock_.now_s;
  for (int k = 0; k < 11; ++k) {
    static_cast<void>(replay.wait_for_frame());
    EXPECT_NEAR(clock_.now_s - start_s, 0.2 * k, 1e-9);
    clock_.now_s += 0.1;
  }
}

TEST_F(Replay, UnpacedNeverWaits) {
  ReplayCamera replay = camera({.rate_hz = 0.01, .paced = false});
  const double start_s = clock_.now_s;
  while (replay.wait_for_frame()) continue;
  EXPECT_EQ(clock_.now_s, start_s);
}

TEST_F(Replay, ADamagedFrameIsAnErrorEveryTime) {
  ReplayCamera replay(std::make_unique<NumberedCapture>(1), {}, clock_.clock());
  EXPECT_TRUE(replay.wait_for_frame());
  EXPECT_THROW(static_cast<void>(replay.wait_for_frame()), Error);
  EXPECT_THROW(static_cast<void>(replay.wait_for_frame()), Error);
}

TEST_F(Replay, RefusesImpossibleRates) {
  for (const double rate_hz : {0.0, -1.0, 1e9, std::nan("")})
    EXPECT_THROW(camera({.rate_hz = rate_hz}), UsageError);
}

}  // namespace
}  // namespace rva
