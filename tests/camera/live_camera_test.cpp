#include "camera/live_camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "tests/camera/scripted_camera.hpp"
#include "tests/eventually.hpp"

namespace rva {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;

class Live : public testing::Test {
 protected:
  Live()
      : script_(std::make_shared<test::CameraScript>()),
        live_(std::make_unique<test::ScriptedCamera>(script_), 1000.0) {}
  ~Live() override { script_->end(); }

  // Gives a frame and returns when it has come through.
  void give(std::uint64_t number) {
    const auto before = live_.newest();
    script_->give(number);
    ASSERT_TRUE(test::eventually([&] { return live_.newest() != before; }));
  }
  void fail(const std::string& problem) {
    script_->fail(problem);
    ASSERT_TRUE(test::eventually([&] { return !live_.health().problem.empty(); }));
  }

  std::shared_ptr<test::CameraScript> script_;
  LiveCamera live_;
};

std::vector<std::uint64_t> numbers(Camera& camera, int count) {
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(camera.wait_for_frame()->number);
  return numbers;
}

TEST_F(Live, ShowsTheNewestFrameAndNothingBefore) {
  EXPECT_EQ(live_.newest(), nullptr);
  give(0);
  give(1);
  EXPECT_EQ(live_.newest()->frame.number, 1U);
  EXPECT_EQ(live_.wait_for_other(live_.newest().get(), milliseconds(1)), nullptr) << "there is no other yet";
}

TEST_F(Live, ACameraWithoutExposureControlRefusesAnExposure) {
  EXPECT_FALSE(live_.exposure_control()) << "before the first frame";
  give(0);
  EXPECT_FALSE(live_.exposure_control());
  EXPECT_THROW(live_.set_exposure({.automatic = true}), Error);
}

TEST_F(Live, ManyReadersGetEveryFrameEach) {
  give(0);
  const auto a = live_.every_frame();
  const auto b = live_.every_frame();
  give(1);  // was under way when they began
  for (std::uint64_t number = 2; number < 7; ++number) give(number);
  EXPECT_THAT(numbers(*a, 5), ElementsAre(2, 3, 4, 5, 6));
  EXPECT_THAT(numbers(*b, 5), ElementsAre(2, 3, 4, 5, 6));
}

TEST_F(Live, AReaderWhoIsLateLosesTheOldestFrames) {
  const auto reader = live_.every_frame();
  for (std::uint64_t number = 0; number < 50; ++number) give(number);
  EXPECT_THAT(numbers(*reader, 2), ElementsAre(20, 21)) << "thirty wait";
}

// A person who ends a capture does not wait until a camera counts as silent.
TEST_F(Live, AWaitEndsWhenTheWorkIsToEnd) {
  give(0);
  int asked = 0;
  const auto reader = live_.every_frame([&asked] {
    if (++asked == 3) throw Interrupted(0);
  });
  EXPECT_THROW(static_cast<void>(reader->wait_for_frame()), Interrupted);
  EXPECT_EQ(asked, 3);
  give(1);
  give(2);
  EXPECT_THAT(numbers(*reader, 1), ElementsAre(2)) << "and the reader goes on";
}

TEST_F(Live, WhatWaitedIsForgottenOnRequest) {
  const auto reader = live_.every_frame();
  for (std::uint64_t number = 0; number < 5; ++number) give(number);
  reader->drop_waiting();
  give(5);  // began, perhaps, before
  give(6);
  EXPECT_THAT(numbers(*reader, 1), ElementsAre(6));
}

// A frame that was under way when the light was switched may be of either light.
TEST_F(Live, FramesUnderTheLampGoToTheReaderThatAskedForItAlone) {
  const auto is_under_lamp = [](const CameraFrame& frame) { return frame.metadata.laser_power_mw == 0.0; };
  give(0);
  const auto under_lamp = live_.every_frame();
  const auto other = live_.every_frame();
  give(1);
  give(2);
  EXPECT_TRUE(under_lamp->has_lamp());
  under_lamp->set_light(Light::lamp);
  for (std::uint64_t number = 3; number < 6; ++number) script_->give(number);
  for (CameraFrame frame = *under_lamp->wait_for_frame(); frame.number < 5;
       frame = *under_lamp->wait_for_frame())
    EXPECT_TRUE(is_under_lamp(frame)) << frame.number;
  EXPECT_LE(live_.newest()->frame.number, 3U) << "a picture without depth is shown to nobody";
  under_lamp->set_light(Light::projector);
  script_->give(6);
  give(7);
  EXPECT_FALSE(is_under_lamp(live_.newest()->frame));
  for (Camera* const reader : {under_lamp.get(), other.get()}) {
    CameraFrame frame = *reader->wait_for_frame();
    for (; frame.number < 7; frame = *reader->wait_for_frame())
      EXPECT_FALSE(is_under_lamp(frame)) << frame.number;
    EXPECT_EQ(frame.number, 7U);
  }
  EXPECT_EQ(live_.health().lost, 0U);
}

TEST_F(Live, AReaderThatGoesTurnsTheProjectorOnAgain) {
  give(0);
  live_.every_frame()->set_light(Light::lamp);
  script_->give(1);  // may still be under the lamp
  give(2);
  EXPECT_EQ(live_.newest()->frame.metadata.laser_power_mw, std::nullopt);
}

TEST_F(Live, CountsFramesThatTheCameraLost) {
  give(3);
  give(4);
  give(9);
  EXPECT_EQ(live_.health().lost, 4U);
  EXPECT_EQ(live_.health().frames, 3U);
}

TEST_F(Live, ACameraThatGoesAwayIsSaidToReadersAndComesBack) {
  give(0);
  const auto reader = live_.every_frame();
  fail("was unplugged");
  EXPECT_THAT(live_.health().problem, HasSubstr("was unplugged"));
  EXPECT_THROW(static_cast<void>(reader->wait_for_frame()), Error);
  give(1);
  give(2);
  EXPECT_EQ(live_.health().problem, "");
  EXPECT_THAT(numbers(*reader, 1), ElementsAre(2));
}

TEST_F(Live, AReaderThatBeganAfterAFailureHearsOfTheNextOnly) {
  fail("was unplugged");
  const auto reader = live_.every_frame();
  give(0);
  give(1);
  EXPECT_THAT(numbers(*reader, 1), ElementsAre(1));
}

}  // namespace
}  // namespace rva
