#include "camera/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <thread>
#include <utility>

#include "camera/infrared_sum.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/options.hpp"

namespace rva {
namespace {

CameraFrame next_frame(Camera& camera, std::size_t done, std::size_t frames) {
  throw_if_interrupted();
  std::optional<CameraFrame> frame = camera.wait_for_frame();
  if (frame) return std::move(*frame);
  throw Error("camera", fmt::format("the recording ended after {} of {} frames", done, frames),
              "use fewer frames");
}

void write(CaptureSink& sink, std::size_t number, const CameraFrame& frame) {
  sink.write_depth(number, frame.depth);
  if (frame.color) sink.write_color(number, *frame.color);
}

FrameMetadata metadata_of(const CameraFrame& frame) {
  FrameMetadata metadata = frame.metadata;
  if (!metadata.counter) metadata.counter = frame.number;
  if (!metadata.time_s) metadata.time_s = frame.time_s;
  return metadata;
}

void require_frames(std::size_t frames) {
  if (frames == 0) throw OptionError("frames", "0 is out of range", "give 1 or more");
}

Recorded record_frames(Camera& camera, std::size_t frames, CaptureSink& sink, InfraredSum& infrared,
                       const Progress& progress) {
  const std::size_t in_flight = 2UL * std::max(1U, std::thread::hardware_concurrency());
  // Its destructor waits for all tasks, so that none outlives the sink after an exception.
  std::deque<std::future<void>> queue;
  Recorded recorded;
  std::uint64_t next_number = 0;
  for (std::size_t number = 0; number < frames; ++number) {
    if (queue.size() == in_flight) {
      queue.front().get();
      queue.pop_front();
    }
    CameraFrame frame = next_frame(camera, number, frames);
    if (number > 0) recorded.lost += frame.number - next_number;
    next_number = frame.number + 1;
    infrared.add(frame);
    sink.write_metadata(number, metadata_of(frame));
    queue.push_back(std::async(std::launch::async,
                               [&sink, number, frame = std::move(frame)] { write(sink, number, frame); }));
    ++recorded.frames;
    if (progress) progress("recording", number + 1, frames);
  }
  for (std::future<void>& written : queue) written.get();
  return recorded;
}

/// Switches to the lamp, and back to the projector on destruction.
class UnderLamp {
 public:
  explicit UnderLamp(Camera& camera) : camera_(camera) { camera_.set_light(Light::lamp); }
  ~UnderLamp() { camera_.set_light(Light::projector); }
  UnderLamp(const UnderLamp&) = delete;
  UnderLamp& operator=(const UnderLamp&) = delete;

 private:
  Camera& camera_;
};

}  // namespace

Recorded record(Camera& camera, std::size_t frames, CaptureSink& sink, const Progress& progress) {
  require_frames(frames);
  InfraredSum infrared;
  Recorded recorded;
  try {
    recorded = record_frames(camera, frames, sink, infrared, progress);
  } catch (...) {
    infrared.write(Light::projector, sink);
    throw;
  }
  infrared.write(Light::projector, sink);
  return recorded;
}

void record_lamp(Camera& camera, std::size_t frames, CaptureSink& sink, const Progress& progress) {
  require_frames(frames);
  const UnderLamp light(camera);
  InfraredSum infrared;
  for (std::size_t number = 0; number < frames; ++number) {
    infrared.add(next_frame(camera, number, frames));
    if (progress) progress("recording under the lamp", number + 1, frames);
  }
  if (infrared.empty())
    throw Error("camera", "gives no infrared images, for which the lamp is meant", "record without the lamp");
  infrared.write(Light::lamp, sink);
}

}  // namespace rva
