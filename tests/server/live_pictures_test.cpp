#include "server/live_pictures.hpp"

#include <gtest/gtest.h>

#include <semaphore>
#include <vector>

#include "depth/image_file.hpp"
#include "tests/eventually.hpp"
#include "tests/server/known_frames_camera.hpp"

namespace rva {
namespace {

using Picture = std::shared_ptr<const LivePicture>;

class LivePicturesTest : public testing::Test {
 protected:
  ~LivePicturesTest() override { frames_->end(); }

  void give(std::uint64_t number, std::uint16_t depth = 800, std::uint8_t grey = 100) {
    frames_->give(number, depth, grey);
  }
  [[nodiscard]] std::vector<Picture> received() const {
    const std::lock_guard lock(mutex_);
    return received_;
  }
  /// The next picture of a stream and a frame; streams that come before it in a frame have then been encoded.
  Picture wait_for(Stream stream, std::uint64_t number) {
    Picture found;
    EXPECT_TRUE(test::eventually([&] {
      for (const Picture& picture : received())
        if (picture->stream == stream && picture->number == number) found = picture;
      return found != nullptr;
    })) << name_of(stream)
        << " " << number;
    return found;
  }
  [[nodiscard]] std::vector<std::uint64_t> numbers(Stream stream) const {
    std::vector<std::uint64_t> numbers;
    for (const Picture& picture : received())
      if (picture->stream == stream) numbers.push_back(picture->number);
    return numbers;
  }

  mutable std::mutex mutex_;
  std::vector<Picture> received_;
  std::function<void(const LivePicture&)> while_receiving_;
  std::shared_ptr<test::Frames> frames_ = std::make_shared<test::Frames>();
  LiveCamera camera_{std::make_unique<test::KnownFramesCamera>(frames_), 1000.0};
  LivePictures pictures_{camera_, [this](const Picture& picture) {
                           if (while_receiving_) while_receiving_(*picture);
                           const std::lock_guard lock(mutex_);
                           received_.push_back(picture);
                         }};
};

TEST_F(LivePicturesTest, AreOfStreamsThatAreWatched) {
  pictures_.watch(Stream::infrared, 1);
  give(1);
  wait_for(Stream::infrared, 1);
  pictures_.watch(Stream::depth, 2);
  give(2);
  wait_for(Stream::infrared, 2);
  pictures_.watch(Stream::depth, -1);
  give(3);
  wait_for(Stream::infrared, 3);
  pictures_.watch(Stream::depth, -1);
  give(4);
  wait_for(Stream::infrared, 4);
  EXPECT_EQ(numbers(Stream::depth), (std::vector<std::uint64_t>{2, 3})) << "one of two viewers was left at 3";
  EXPECT_EQ(numbers(Stream::color), std::vector<std::uint64_t>{});
  EXPECT_EQ(numbers(Stream::infrared), (std::vector<std::uint64_t>{1, 2, 3, 4}));
}

TEST_F(LivePicturesTest, ShowWhatTheCameraSees) {
  for (const auto& [stream, name] : enum_names<Stream>) pictures_.watch(stream, 1);
  const auto before = std::chrono::system_clock::now();
  give(7, 800, 140);
  const Picture infrared = wait_for(Stream::infrared, 7);
  const Picture color = wait_for(Stream::color, 7);
  const Picture depth = wait_for(Stream::depth, 7);
  for (const Picture& picture : {color, infrared}) {
    const ColorImage image = decode_color(picture->jpeg, "picture");
    EXPECT_EQ(image.width(), picture->width);
    EXPECT_EQ(picture->width, test::Frames::width);
    EXPECT_EQ(picture->height, test::Frames::height);
    EXPECT_NEAR(image(5, 5).r, 140, 2);
    EXPECT_NEAR(image(5, 5).b, 140, 2);
    EXPECT_FALSE(picture->scale_m);
    EXPECT_GE(picture->taken_at, before);
  }
  ASSERT_TRUE(depth->scale_m);
  EXPECT_LE(depth->scale_m->low, 0.8F);
  EXPECT_GE(depth->scale_m->high, 0.8F);
}

TEST_F(LivePicturesTest, OfDepthKeepTheirColoursForAWhile) {
  pictures_.watch(Stream::depth, 1);
  give(100, 800);
  const ColorScale first = *wait_for(Stream::depth, 100)->scale_m;
  give(129, 2000);
  EXPECT_EQ(wait_for(Stream::depth, 129)->scale_m->high, first.high) << "colours would flicker";
  give(130, 2000);
  const ColorScale second = *wait_for(Stream::depth, 130)->scale_m;
  EXPECT_GE(second.high, 2.0F);
  give(3, 800);
  EXPECT_EQ(wait_for(Stream::depth, 3)->scale_m->high, first.high) << "the camera has begun anew";
}

TEST_F(LivePicturesTest, OfFramesWithoutAnImageAreLeftOut) {
  for (const auto& [stream, name] : enum_names<Stream>) pictures_.watch(stream, 1);
  frames_->give_depth_only(1);
  wait_for(Stream::depth, 1);
  give(2);
  wait_for(Stream::infrared, 2);
  EXPECT_EQ(numbers(Stream::color), std::vector<std::uint64_t>{2});
  EXPECT_EQ(numbers(Stream::infrared), std::vector<std::uint64_t>{2});
}

TEST_F(LivePicturesTest, StreamsAreThoseOfTheCamera) {
  EXPECT_TRUE(pictures_.streams().empty()) << "before the first frame";
  give(1);
  ASSERT_TRUE(test::eventually([&] { return camera_.newest() != nullptr; }));
  EXPECT_EQ(pictures_.streams(), (std::vector{Stream::color, Stream::depth, Stream::infrared}));
  frames_->give_depth_only(2);
  ASSERT_TRUE(test::eventually([&] { return camera_.newest()->frame.number == 2; }));
  EXPECT_EQ(pictures_.streams(), (std::vector{Stream::color, Stream::depth}))
      << "colour may be missing in every second frame";
}

TEST_F(LivePicturesTest, OnlyTheNewestFrameWaits) {
  std::binary_semaphore received{0};
  std::binary_semaphore go_on{0};
  while_receiving_ = [&](const LivePicture& picture) {
    if (picture.number != 1) return;
    received.release();
    go_on.acquire();
  };
  pictures_.watch(Stream::infrared, 1);
  give(1);
  received.acquire();
  for (const std::uint64_t number : {2U, 3U, 4U, 5U}) give(number);
  const bool came = test::eventually([&] { return camera_.newest()->frame.number == 5; });
  go_on.release();
  EXPECT_TRUE(came);
  wait_for(Stream::infrared, 5);
  EXPECT_EQ(numbers(Stream::infrared), (std::vector<std::uint64_t>{1, 5}));
}

}  // namespace
}  // namespace rva
