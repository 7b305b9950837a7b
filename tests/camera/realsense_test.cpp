// A RealSense that is not there: librealsense's own software device, recorder and playback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <librealsense2/rsutil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <future>
#include <librealsense2/hpp/rs_internal.hpp>
#include <map>
#include <thread>
#include <tuple>

#include "camera/live_camera.hpp"
#include "camera/realsense/realsense_camera.hpp"
#include "camera/realsense/realsense_frames.hpp"
#include "capture/align.hpp"
#include "capture/capture.hpp"
#include "core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr int width = 848;
constexpr int height = 480;
constexpr const char* serial = "software-1";

rs2_intrinsics intrinsics(float focal_px) {
  return {width, height, 423.5F, 239.5F, focal_px, focal_px, RS2_DISTORTION_BROWN_CONRADY, {0, 0, 0, 0, 0}};
}

DepthImage depth_of(int number) {
  DepthImage image(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) image(u, v) = static_cast<std::uint16_t>(1000 + number + u + v);
  }
  return image;
}

ColorImage color_of(int number) { return {width, height, Rgb{static_cast<std::uint8_t>(number), 100, 200}}; }

/// A depth and a colour imager whose frames the test determines.
class SoftwareDevice {
 public:
  explicit SoftwareDevice(int rate_hz = 30)
      : depth_sensor_(device_.add_sensor("Stereo Module")), color_sensor_(device_.add_sensor("RGB Camera")) {
    device_.register_info(RS2_CAMERA_INFO_NAME, "Software D435");
    device_.register_info(RS2_CAMERA_INFO_SERIAL_NUMBER, serial);
    device_.register_info(RS2_CAMERA_INFO_USB_TYPE_DESCRIPTOR, "2.1");
    depth_ = depth_sensor_.add_video_stream(
        {RS2_STREAM_DEPTH, 0, 0, width, height, rate_hz, 2, RS2_FORMAT_Z16, intrinsics(424.0F)});
    color_ = color_sensor_.add_video_stream(
        {RS2_STREAM_COLOR, 0, 1, width, height, rate_hz, 3, RS2_FORMAT_RGB8, intrinsics(610.0F)});
    depth_sensor_.add_read_only_option(RS2_OPTION_DEPTH_UNITS, 0.0001F);
    depth_sensor_.add_read_only_option(RS2_OPTION_STEREO_BASELINE, 50.0F);
    depth_sensor_.add_option(RS2_OPTION_GAIN, {16, 248, 16, 1}, true);
    depth_sensor_.add_option(RS2_OPTION_LASER_POWER, {0, 120, 60, 30}, true);
    depth_.register_extrinsics_to(color_, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0.015F, 0.001F, 0.002F}});
    device_.create_matcher(RS2_MATCHER_DEFAULT);
  }

  rs2::software_device& device() { return device_; }

  /// @param depth as the camera counts, in frames of its own clock, 33 ms each
  void give(int depth, bool with_color = true) {
    send(depth_sensor_, depth_, depths_[depth] = depth_of(depth), 2, depth);
    if (with_color) send(color_sensor_, color_, colors_[depth] = color_of(depth), 3, depth);
  }

 private:
  template <typename Pixel, typename Meaning>
  static void send(rs2::software_sensor& sensor, const rs2::stream_profile& stream,
                   Image<Pixel, Meaning>& image, int bytes, int number) {
    sensor.on_video_frame({image.data(), [](void*) {}, width * bytes, bytes, 33.0 * number,
                           RS2_TIMESTAMP_DOMAIN_HARDWARE_CLOCK, number, stream.get(), 0.0001F});
  }

  std::map<int, DepthImage> depths_;  // librealsense keeps the pixels where they are
  std::map<int, ColorImage> colors_;
  rs2::software_device device_;
  rs2::software_sensor depth_sensor_;
  rs2::software_sensor color_sensor_;
  rs2::stream_profile depth_;
  rs2::stream_profile color_;
};

class RealSense : public testing::Test {
 protected:
  RealSense() {
    // librealsense forgets a device that nobody holds.
    context_.set_devices_changed_callback(
        [this](const rs2::event_information& event) { held_ = event.get_new_devices(); });
    software_.device().add_to(context_);
  }

  SoftwareDevice software_;
  rs2::context context_;
  rs2::device_list held_;
};

TEST_F(RealSense, GivesFramesWithWhatBelongsToThem) {
  RealSenseCamera camera(context_, serial, {});
  for (int number = 5; number < 9; ++number) software_.give(number);
  std::uint64_t before = 0;
  for (int number = 5; number < 9; ++number) {
    const auto frame = camera.wait_for_frame();
    EXPECT_EQ(frame->depth, depth_of(number));
    EXPECT_EQ(frame->color, color_of(number));
    EXPECT_TRUE(number == 5 || frame->number == before + 1);
    EXPECT_NEAR(frame->time_s, 0.033 * number, 1e-9);
    before = frame->number;
  }
}

TEST_F(RealSense, CountsFramesThatWereLost) {
  RealSenseCamera camera(context_, serial, {});
  software_.give(1);
  const std::uint64_t first = camera.wait_for_frame()->number;
  software_.give(4);
  EXPECT_EQ(camera.wait_for_frame()->number, first + 3);
}

TEST_F(RealSense, SaysWhatItIsAndHowItIsSet) {
  const RealSenseCamera camera(context_, serial, {.gain = 32});
  const CaptureInfo info = camera.info();
  EXPECT_EQ(info.depth.width, width);
  EXPECT_EQ(info.depth.fx, 424.0);
  EXPECT_EQ(info.color->fx, 610.0);
  EXPECT_EQ(info.depth_unit_m, 0.0001);
  EXPECT_NEAR(info.color_from_depth->translation().x(), 0.015, 1e-9);
  EXPECT_EQ(info.camera->model, "Software D435");
  EXPECT_EQ(info.camera->serial, serial);
  EXPECT_EQ(info.camera->baseline_m, 0.05);
  EXPECT_EQ(info.camera->settings.at("Stereo Module").at("Gain"), 32.0);
}

TEST_F(RealSense, SaysWhatItDidNotTakeAndWhatTheUsbPortCosts) {
  const RealSenseCamera camera(context_, serial, {.laser_power_mw = 150});  // 120 is its most
  const std::vector<std::string> notes = camera.info().notes;
  EXPECT_THAT(notes, testing::Contains(testing::HasSubstr("'Laser Power' is 60, not 150")));
  EXPECT_THAT(notes, testing::Contains(testing::HasSubstr("no setting 'Exposure'")));
  EXPECT_THAT(notes, testing::Contains(testing::HasSubstr("USB 2.1")));
}

TEST_F(RealSense, SilenceIsSaidAndFramesAfterItCome) {
  RealSenseCamera camera(context_, serial, {}, 0.3);
  software_.give(1);
  const std::uint64_t first = camera.wait_for_frame()->number;
  EXPECT_THAT([&] { static_cast<void>(camera.wait_for_frame()); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("no frame for some seconds")));
  // It is opened anew by the next call, and counts from the beginning.
  std::future<void> later = std::async(std::launch::async, [&] {
    for (int number = 1; number < 20; ++number) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      software_.give(number);
    }
  });
  std::optional<CameraFrame> frame;
  for (int tries = 0; tries < 20 && !frame; ++tries) {
    try {
      frame = camera.wait_for_frame();
    } catch (const Error&) {
      // not yet
    }
  }
  later.get();
  ASSERT_TRUE(frame);
  EXPECT_GT(frame->number, first + 1) << "what was missed shows";
}

TEST_F(RealSense, OtherSerialsAreNotThere) {
  EXPECT_THAT([&] { RealSenseCamera(context_, "other", {}); },
              testing::ThrowsMessage<Error>(
                  testing::AllOf(testing::HasSubstr("realsense:other"), testing::HasSubstr("rva cameras"))));
}

TEST_F(RealSense, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(RealSenseCamera(context_, serial, {.gain = 1}), UsageError);
}

TEST_F(RealSense, IsWatchedByManyAndRecordedWhole) {
  LiveCamera live(std::make_unique<RealSenseCamera>(context_, serial, RealSenseOptions{}), 1000.0);
  software_.give(1);
  ASSERT_NE(live.wait_for_other(nullptr, std::chrono::seconds(5)), nullptr);
  const std::unique_ptr<Camera> every = live.every_frame();
  for (int number = 2; number < 20; ++number) software_.give(number);
  EXPECT_EQ(every->info().camera->serial, serial);
  // The frame that was under way when the reader came is left out.
  for (int number = 3; number < 20; ++number) EXPECT_EQ(every->wait_for_frame()->depth, depth_of(number));
}

/// Depth seen from the colour camera, by librealsense's own functions.
class Projection {
 public:
  Projection(const rs2::video_stream_profile& depth, const rs2::video_stream_profile& color)
      : depth_(depth.get_intrinsics()),
        color_(color.get_intrinsics()),
        color_from_depth_(depth.get_extrinsics_to(color)) {}

  [[nodiscard]] DepthImage aligned(const DepthImage& depth) const {
    DepthImage aligned(color_.width, color_.height);
    for (int v = 0; v < depth.height(); ++v) {
      for (int u = 0; u < depth.width(); ++u)
        if (depth(u, v) != no_depth) put(aligned, u, v, depth(u, v));
    }
    return aligned;
  }

 private:
  /// The corner of a depth pixel in the colour image.
  [[nodiscard]] std::array<float, 2> in_color(std::array<float, 2> corner, float z_m) const {
    std::array<float, 3> in_depth{};
    std::array<float, 3> in_color{};
    std::array<float, 2> pixel{};
    rs2_deproject_pixel_to_point(in_depth.data(), &depth_, corner.data(), z_m);
    rs2_transform_point_to_point(in_color.data(), &color_from_depth_, in_depth.data());
    rs2_project_point_to_pixel(pixel.data(), &color_, in_color.data());
    return pixel;
  }

  void put(DepthImage& aligned, int u, int v, std::uint16_t depth) const {
    const float z_m = 0.001F * static_cast<float>(depth);
    const auto corner = [&](float offset) {
      return in_color({static_cast<float>(u) + offset, static_cast<float>(v) + offset}, z_m);
    };
    const auto [left, top] = corner(-0.5F);
    const auto [right, bottom] = corner(0.5F);
    if (left < -0.5F || top < -0.5F || std::lround(right) >= color_.width ||
        std::lround(bottom) >= color_.height)
      return;
    for (int y = static_cast<int>(std::lround(top)); y <= static_cast<int>(std::lround(bottom)); ++y) {
      for (int x = static_cast<int>(std::lround(left)); x <= static_cast<int>(std::lround(right)); ++x) {
        std::uint16_t& there = aligned(x, y);
        if (there == no_depth || depth < there) there = depth;
      }
    }
  }

  rs2_intrinsics depth_;
  rs2_intrinsics color_;
  rs2_extrinsics color_from_depth_;
};

// By the intrinsics and extrinsics of a real camera. Not against rs2::align itself, which in its SSE version
// adds half a pixel before it rounds, and so puts depth half a pixel to the right and below.
TEST(Align, PutsDepthWhereLibrealsensesProjectionPutsIt) {
  const std::string file = RVA_SHARED "/data/d435.bag";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  rs2::context context;
  rs2::playback device = context.load_device(file);
  std::map<rs2_stream, rs2::video_stream_profile> profiles;
  for (const rs2::sensor& sensor : device.query_sensors()) {
    for (const rs2::stream_profile& profile : sensor.get_stream_profiles())
      profiles[profile.stream_type()] = profile.as<rs2::video_stream_profile>();
  }
  const std::unique_ptr<Capture> ours = open_capture(file);
  const DepthImage depth = ours->depth(0);
  const Projection theirs(profiles.at(RS2_STREAM_DEPTH), profiles.at(RS2_STREAM_COLOR));
  const DepthImage expected = theirs.aligned(depth);
  const DepthImage aligned = align_to_color(depth, ours->info());
  ASSERT_EQ(aligned.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    if (aligned[i] != expected[i]) ++different;
  }
  // Theirs reckons in single precision: a corner falls into the pixel beside now and then.
  EXPECT_LT(different, aligned.size() / 1000);
  EXPECT_GT(std::ranges::count_if(aligned.pixels(), [](std::uint16_t z) { return z != no_depth; }), 250'000);
}

struct Playback {
  std::map<rs2_stream, std::vector<rs2::frame>> frames;
  std::map<rs2_stream, Intrinsics> intrinsics;
  Transform color_from_depth;
};

/// All frames of a file as librealsense's playback gives them: not by a pipeline, which drops the first.
Playback played_back(const std::string& file) {
  rs2::context context;
  rs2::playback device = context.load_device(file);
  device.set_real_time(false);
  device.pause();  // until every sensor is started: frames of others are passed over
  rs2::frame_queue queue(100, true);
  std::vector<rs2::sensor> sensors = device.query_sensors();
  std::map<rs2_stream, rs2::stream_profile> profiles;
  Playback playback;
  for (rs2::sensor& sensor : sensors) {
    for (const rs2::stream_profile& profile : sensor.get_stream_profiles()) {
      profiles[profile.stream_type()] = profile;
      playback.intrinsics[profile.stream_type()] =
          to_intrinsics(profile.as<rs2::video_stream_profile>().get_intrinsics());
    }
    sensor.open(sensor.get_stream_profiles());
    sensor.start(queue);
  }
  device.resume();
  rs2::frame frame;
  while (queue.try_wait_for_frame(&frame, 1000))
    playback.frames[frame.get_profile().stream_type()].push_back(frame);
  playback.color_from_depth =
      to_transform(profiles.at(RS2_STREAM_DEPTH).get_extrinsics_to(profiles.at(RS2_STREAM_COLOR)));
  for (rs2::sensor& sensor : sensors) {
    sensor.stop();
    sensor.close();
  }
  return playback;
}

// Databases state them in decimals, which librealsense reads in single precision.
void expect_same(const Intrinsics& ours, const Intrinsics& theirs) {
  EXPECT_EQ(std::tie(ours.width, ours.height, ours.distortion),
            std::tie(theirs.width, theirs.height, theirs.distortion));
  const auto numbers = [](const Intrinsics& camera) {
    return std::array{camera.fx, camera.fy, camera.cx, camera.cy};
  };
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_FLOAT_EQ(static_cast<float>(numbers(ours)[i]), static_cast<float>(numbers(theirs)[i]));
  for (std::size_t i = 0; i < ours.coefficients.size(); ++i)
    EXPECT_FLOAT_EQ(static_cast<float>(ours.coefficients[i]), static_cast<float>(theirs.coefficients[i]));
}

void expect_same(const std::string& file) {
  const Playback theirs = played_back(file);
  const std::unique_ptr<Capture> ours = open_capture(file);
  const auto& depth = theirs.frames.at(RS2_STREAM_DEPTH);
  ASSERT_EQ(ours->depth_frames(), depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const rs2::depth_frame frame = depth[i].as<rs2::depth_frame>();
    EXPECT_EQ(ours->depth(i), to_depth_image(frame)) << i;
    EXPECT_FLOAT_EQ(static_cast<float>(ours->info().depth_unit_m), frame.get_units());
    EXPECT_EQ(ours->metadata_of(i).counter, frame.get_frame_number());
  }
  const auto& color = theirs.frames.at(RS2_STREAM_COLOR);
  ASSERT_EQ(ours->color_frames(), color.size());
  for (std::size_t i = 0; i < color.size(); ++i)
    EXPECT_EQ(ours->color(i), to_color_image(color[i].as<rs2::video_frame>())) << i;
  expect_same(ours->info().depth, theirs.intrinsics.at(RS2_STREAM_DEPTH));
  expect_same(*ours->info().color, theirs.intrinsics.at(RS2_STREAM_COLOR));
  EXPECT_TRUE(ours->info().color_from_depth->isApprox(theirs.color_from_depth, 1e-5));
}

TEST(Recorded, BagOfARealD435IsReadAsLibrealsenseReadsIt) {
  const std::filesystem::path file = RVA_SHARED "/data/d435.bag";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  expect_same(file);
}

TEST(Recorded, DatabaseOfARealD435IsReadAsLibrealsenseReadsIt) {
#if RS2_API_MAJOR_VERSION * 100 + RS2_API_MINOR_VERSION >= 258
  const std::filesystem::path bag = RVA_SHARED "/data/d435.bag";
  if (!std::filesystem::exists(bag)) GTEST_SKIP() << bag << " is not there";
  const test::TemporaryFolder folder;
  const std::string file = folder / "converted.db3";
  rs2::context().convert_bag_to_db3(bag, file);
  expect_same(file);
#else
  GTEST_SKIP() << "librealsense " << RS2_API_VERSION_STR << " does not support .db3";
#endif
}

class RecordedByLibrealsense : public testing::TestWithParam<bool> {};

TEST_P(RecordedByLibrealsense, IsReadAsItReadsIt) {
  const bool packed = GetParam();
  const test::TemporaryFolder folder;
  constexpr bool knows_db3 = RS2_API_MAJOR_VERSION * 100 + RS2_API_MINOR_VERSION >= 258;
  const std::string file = folder / (knows_db3 ? "recorded.db3" : "recorded.bag");
  SoftwareDevice software;
  {
    rs2::recorder recorder(file, software.device(), packed);
    rs2::frame_queue queue(100, true);
    std::vector<rs2::sensor> sensors = recorder.query_sensors();
    for (rs2::sensor& sensor : sensors) {
      sensor.open(sensor.get_stream_profiles());
      sensor.start(queue);
    }
    rs2::frame frame;
    for (int number = 1; number < 12; ++number) {
      software.give(number);
      ASSERT_TRUE(queue.try_wait_for_frame(&frame, 5000) && queue.try_wait_for_frame(&frame, 5000));
    }
    for (rs2::sensor& sensor : sensors) {
      sensor.stop();
      sensor.close();
    }
  }
  expect_same(file);
}

INSTANTIATE_TEST_SUITE_P(PackedOrNot, RecordedByLibrealsense, testing::Bool());

}  // namespace
}  // namespace rva
