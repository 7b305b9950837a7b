#include "capture/frame_reader.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

TEST(FrameReader, HandsFramesOverInOrder) {
  std::vector<DepthImage> frames;
  for (int k = 0; k < 50; ++k) frames.emplace_back(4, 3, static_cast<std::uint16_t>(k + 1));
  const test::MemoryCapture capture = test::capture_of(frames);
  std::vector<int> seen;
  std::vector<std::size_t> reported;
  for_each_depth_frame(
      capture, 40, [&](std::string_view, std::size_t done, std::size_t) { reported.push_back(done); },
      [&](const DepthImage& frame) { seen.push_back(frame[0]); });
  ASSERT_EQ(seen.size(), 40U);
  for (int k = 0; k < 40; ++k) EXPECT_EQ(seen[static_cast<std::size_t>(k)], k + 1);
  EXPECT_EQ(reported.back(), 40U);
}

class BrokenCapture : public test::MemoryCapture {
 public:
  using MemoryCapture::MemoryCapture;
  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    if (i >= 5) throw Error("frame", "damaged", "record it again");
    return MemoryCapture::depth(i);
  }
};

TEST(FrameReader, StopsAtTheFirstDamagedFrame) {
  const BrokenCapture capture(test::info_of(4, 3), std::vector<DepthImage>(20, DepthImage(4, 3, 9)));
  int used = 0;
  EXPECT_THROW(for_each_depth_frame(capture, 20, {}, [&](const DepthImage&) { ++used; }), Error);
  EXPECT_EQ(used, 5);
}

TEST(FrameReader, PassesOnWhatItsUserThrows) {
  const test::MemoryCapture capture = test::capture_of(std::vector<DepthImage>(20, DepthImage(4, 3, 9)));
  EXPECT_THROW(
      for_each_depth_frame(capture, 20, {}, [](const DepthImage&) { throw Error("use", "full", "stop"); }),
      Error);
}

}  // namespace
}  // namespace rva
