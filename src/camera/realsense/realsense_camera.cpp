#include "camera/realsense/realsense_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "camera/realsense/plugged_in.hpp"
#include "camera/realsense/realsense_frames.hpp"
#include "camera/realsense/realsense_settings.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr int width = 848;
constexpr int height = 480;
// One second of frames: the oldest are dropped if the reader is later than that.
constexpr unsigned most_waiting = 30;
// The imagers by librealsense's stream index.
constexpr std::array<std::pair<Imager, int>, 2> infrared_streams{{{Imager::left, 1}, {Imager::right, 2}}};

std::string text_of(const rs2::device& device, rs2_camera_info what) {
  return device.supports(what) ? device.get_info(what) : "";
}

std::string name_of(const rs2::sensor& sensor) {
  return sensor.supports(RS2_CAMERA_INFO_NAME) ? sensor.get_info(RS2_CAMERA_INFO_NAME) : "sensor";
}

// librealsense passes on the system's error as text only.
Error not_opened(const std::string& source, const rs2::error& failure) {
  const std::string reason = failure.what();
  const auto mentions = [&](const char* word) { return reason.find(word) != std::string::npos; };
  if (mentions("busy") || mentions("Busy"))
    return {source, "is in use by another program", "close it (realsense-viewer?) and try again"};
  if (mentions("ermission") || mentions("ccess"))
    return {source, "may not be opened by this user",
            "install librealsense's udev rules (see docs/cameras.md) and plug the camera in again"};
  return {source, fmt::format("does not start ({})", printable(reason)), "plug it in again, to a USB 3 port"};
}

rs2::config streams(const std::string& serial, int rate_hz, bool color, bool infrared) {
  rs2::config config;
  config.enable_device(serial);
  config.enable_stream(RS2_STREAM_DEPTH, width, height, RS2_FORMAT_Z16, rate_hz);
  if (color) config.enable_stream(RS2_STREAM_COLOR, width, height, RS2_FORMAT_RGB8, rate_hz);
  for (const auto& [imager, index] : infrared_streams) {
    if (infrared) config.enable_stream(RS2_STREAM_INFRARED, index, width, height, RS2_FORMAT_Y8, rate_hz);
  }
  return config;
}

CaptureInfo describe(const rs2::pipeline_profile& profile, const rs2::sensor& depth_sensor) {
  const rs2::device device = profile.get_device();
  const auto depth = profile.get_stream(RS2_STREAM_DEPTH).as<rs2::video_stream_profile>();
  CaptureInfo info;
  info.depth = to_intrinsics(depth.get_intrinsics());
  // The camera stores it as a float: rounding restores the decimal value.
  info.depth_unit_m =
      std::round(1e7 * static_cast<double>(depth_sensor.get_option(RS2_OPTION_DEPTH_UNITS))) / 1e7;
  CameraInfo camera{.model = text_of(device, RS2_CAMERA_INFO_NAME),
                    .serial = text_of(device, RS2_CAMERA_INFO_SERIAL_NUMBER),
                    .firmware = text_of(device, RS2_CAMERA_INFO_FIRMWARE_VERSION),
                    .usb = text_of(device, RS2_CAMERA_INFO_USB_TYPE_DESCRIPTOR)};
  if (depth_sensor.supports(RS2_OPTION_STEREO_BASELINE))
    camera.baseline_m = 0.001 * static_cast<double>(depth_sensor.get_option(RS2_OPTION_STEREO_BASELINE));
  for (const rs2::sensor& sensor : device.query_sensors())
    camera.settings[name_of(sensor)] = read_settings(sensor);
  info.camera = std::move(camera);
  for (const rs2::stream_profile& stream : profile.get_streams()) {
    if (stream.stream_type() != RS2_STREAM_COLOR) continue;
    info.color = to_intrinsics(stream.as<rs2::video_stream_profile>().get_intrinsics());
    info.color_from_depth = to_transform(depth.get_extrinsics_to(stream));
  }
  return info;
}

void note_slow_port(CaptureInfo& info, int rate_hz, const RealSenseOptions& options) {
  if (rate_hz != static_cast<int>(options.rate_hz))
    info.notes.push_back(
        fmt::format("the camera gives {} frames per second at this port, not {:.0f} as requested", rate_hz,
                    options.rate_hz));
  if (info.camera->usb.starts_with("2")) {
    info.notes.push_back(
        fmt::format("the camera is connected to a USB {} port, which is too slow for all frames: use a USB 3 "
                    "port and cable",
                    info.camera->usb));
  }
}

}  // namespace

std::vector<FoundCamera> cameras_of(const rs2::context& context) {
  std::vector<FoundCamera> found;
  for (const rs2::device& device : context.query_devices()) {
    found.push_back({.model = text_of(device, RS2_CAMERA_INFO_NAME),
                     .serial = text_of(device, RS2_CAMERA_INFO_SERIAL_NUMBER),
                     .firmware = text_of(device, RS2_CAMERA_INFO_FIRMWARE_VERSION),
                     .usb = text_of(device, RS2_CAMERA_INFO_USB_TYPE_DESCRIPTOR)});
  }
  if (const auto there = plugged_in_realsense(); found.empty() && !there.empty()) {
    throw Error(printable(there.front().product), "is plugged in, but may not be opened by this user",
                "install librealsense's udev rules (see docs/cameras.md) and plug the camera in again");
  }
  return found;
}

RealSenseCamera::RealSenseCamera(rs2::context context, std::string serial, const RealSenseOptions& options,
                                 double silence_s)
    : context_(std::move(context)),
      serial_(std::move(serial)),
      options_(options),
      silence_s_(silence_s),
      queue_(most_waiting, true) {
  check_options(options_);
  if (serial_.empty()) {
    const std::vector<FoundCamera> found = cameras_of(context_);
    if (found.size() > 1) {
      std::string serials;
      for (const FoundCamera& camera : found)
        serials += (serials.empty() ? "realsense:" : ", realsense:") + printable(camera.serial);
      throw Error("realsense", "several cameras are connected", "name one: " + serials);
    }
    if (found.empty()) throw Error("realsense", "no camera is connected", "connect one to a USB 3 port");
    serial_ = found.front().serial;
  }
  open();
}

RealSenseCamera::~RealSenseCamera() { close(); }

bool RealSenseCamera::is_there() const {
  return std::ranges::any_of(cameras_of(context_),
                             [&](const FoundCamera& camera) { return camera.serial == serial_; });
}

void RealSenseCamera::open() {
  const std::string source = "realsense:" + printable(serial_);
  // Without this check, starting would wait for 15 seconds for an absent camera.
  if (!is_there()) throw Error(source, "this camera is not connected", "connect it, or see `rva cameras`");
  try {
    rs2::device device;
    for (const rs2::device& candidate : context_.query_devices()) {
      if (text_of(candidate, RS2_CAMERA_INFO_SERIAL_NUMBER) == serial_) device = candidate;
    }
    const rs2::sensor depth_sensor = device.first<rs2::depth_sensor>();
    std::vector<std::string> notes = apply_settings(depth_sensor, options_);
    rs2::pipeline pipeline(context_);
    const auto asked_hz = static_cast<int>(options_.rate_hz);
    // Some cameras have no colour; a slow port does not allow high rates, or infrared images as well.
    for (const int rate_hz : {asked_hz, 15, 10, 6}) {
      for (const auto& [color, infrared] :
           {std::pair(true, true), {false, true}, {true, false}, {false, false}}) {
        if (infrared && !options_.infrared) continue;
        const rs2::config config = streams(serial_, rate_hz, color, infrared);
        if (!config.can_resolve(pipeline)) continue;
        const rs2::pipeline_profile profile = pipeline.start(config, queue_);
        CaptureInfo info = describe(profile, depth_sensor);
        info.notes = std::move(notes);
        note_slow_port(info, rate_hz, options_);
        if (options_.infrared && !infrared)
          info.notes.emplace_back("its port is too slow for infrared images: depth alone will be compared");
        std::unique_lock lock(mutex_);
        info_ = std::move(info);
        lock.unlock();
        depth_sensor_ = depth_sensor;
        rate_hz_ = rate_hz;
        pipeline_ = std::move(pipeline);
        exposure_ = read_exposure(depth_sensor_, rate_hz_);
        if (chosen_exposure_) set_exposure(Exposure(*chosen_exposure_));
        return;
      }
    }
  } catch (const rs2::error& failure) {
    throw not_opened(source, failure);
  }
  throw Error(source, fmt::format("gives no depth of {}x{} pixels", width, height),
              "use a D415, D435 or D455 at a USB 3 port");
}

void RealSenseCamera::close() {
  if (!pipeline_) return;
  try {
    pipeline_->stop();
  } catch (const rs2::error&) {
    // It has already been disconnected.
  }
  pipeline_.reset();
  device_number_.reset();
}

CaptureInfo RealSenseCamera::info() const {
  const std::lock_guard lock(mutex_);
  return info_;
}

rs2::frameset RealSenseCamera::next_frameset() {
  constexpr unsigned slice_ms = 100;
  const Clock clock = steady_clock();
  const double until_s = clock.now_s() + silence_s_;
  while (clock.now_s() < until_s) {
    throw_if_interrupted();
    rs2::frame frame;
    if (!queue_.try_wait_for_frame(&frame, slice_ms)) continue;
    rs2::frameset set(frame);
    // The pipeline repeats the last depth frame when a colour frame arrives alone.
    const rs2::depth_frame depth = set.get_depth_frame();
    if (depth && depth.get_frame_number() != device_number_) return set;
  }
  const bool there = is_there();
  close();
  throw Error("realsense:" + printable(serial_),
              there ? "has given no frame for some seconds" : "has been unplugged", "check its cable");
}

// A reconnected camera counts from the beginning: the number of missed frames is estimated from the time.
void RealSenseCamera::count(std::uint64_t device_number) {
  const double now_s = steady_clock().now_s();
  if (device_number_ && device_number > *device_number_)
    number_ += device_number - *device_number_;
  else if (last_frame_s_ > 0.0)
    number_ +=
        static_cast<std::uint64_t>(std::max(1LL, std::llround((now_s - last_frame_s_) * options_.rate_hz)));
  device_number_ = device_number;
  last_frame_s_ = now_s;
}

FrameMetadata RealSenseCamera::metadata_of(const rs2::depth_frame& depth) {
  constexpr std::uint64_t frames_between = 30;
  FrameMetadata metadata = to_metadata(depth);
  if (!temperature_c_ || number_ % frames_between == 0) {
    try {
      if (depth_sensor_.supports(RS2_OPTION_ASIC_TEMPERATURE))
        temperature_c_ = static_cast<double>(depth_sensor_.get_option(RS2_OPTION_ASIC_TEMPERATURE));
    } catch (const rs2::error&) {
      temperature_c_.reset();  // not available at the moment
    }
  }
  metadata.counter = number_;
  metadata.temperature_c = temperature_c_;
  return metadata;
}

std::optional<CameraFrame> RealSenseCamera::wait_for_frame() {
  if (!pipeline_) open();
  try {
    const rs2::frameset set = next_frameset();
    const rs2::depth_frame depth = set.get_depth_frame();
    count(depth.get_frame_number());
    CameraFrame frame;
    frame.depth = to_depth_image(depth);
    if (const rs2::video_frame color = set.get_color_frame()) frame.color = to_color_image(color);
    for (const auto& [imager, index] : infrared_streams) {
      if (const rs2::video_frame infrared = set.get_infrared_frame(static_cast<std::size_t>(index)))
        frame.infrared.emplace(imager, fine_gray(to_gray_image(infrared)));
    }
    frame.number = number_;
    frame.time_s = 1e-3 * depth.get_timestamp();
    frame.metadata = metadata_of(depth);
    return frame;
  } catch (const rs2::error& failure) {
    close();
    throw Error("realsense:" + printable(serial_), printable(failure.what()), "plug it in again");
  }
}

void RealSenseCamera::set_exposure(const Exposure& exposure) {
  chosen_exposure_ = exposure;
  if (!pipeline_) return;  // set when the camera is opened again
  const std::string source = "realsense:" + printable(serial_);
  try {
    apply_exposure(depth_sensor_, exposure);
    exposure_ = read_exposure(depth_sensor_, rate_hz_);
    const std::lock_guard lock(mutex_);
    info_.camera->settings[name_of(depth_sensor_)] = read_settings(depth_sensor_);
  } catch (const rs2::error& failure) {
    throw Error(source, fmt::format("refuses the exposure ({})", printable(failure.what())),
                "choose another one");
  }
}

void RealSenseCamera::drop_waiting() {
  rs2::frame frame;
  while (queue_.poll_for_frame(&frame)) {
  }
}

namespace {

// One context for the process, since destroying a context takes seconds.
const rs2::context& shared_context() {
  static const rs2::context context;
  return context;
}

}  // namespace

bool has_realsense() { return true; }

std::vector<FoundCamera> realsense_cameras() { return cameras_of(shared_context()); }

std::unique_ptr<Camera> open_realsense(const std::string& serial, const RealSenseOptions& options) {
  return std::make_unique<RealSenseCamera>(shared_context(), serial, options);
}

}  // namespace rva
