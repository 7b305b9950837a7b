#include "camera/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

CameraFrame next_frame(Camera& camera, std::size_t done, std::size_t frames) {
  throw_if_interrupted();
  std::optional<CameraFrame> frame = camera.wait_for_frame();
  if (frame) return std::move(*frame);
  throw Error("camera", fmt::format("the recording ended after {} of {} frames", done, frames),
              "ask for fewer frames");
}

void write(const CaptureWriter& writer, std::size_t number, const CameraFrame& frame) {
  writer.write_depth(number, frame.depth);
  if (frame.color) writer.write_color(number, *frame.color);
  if (frame.infrared) writer.write_infrared(number, *frame.infrared);
}

FrameMetadata metadata_of(const CameraFrame& frame) {
  FrameMetadata metadata = frame.metadata;
  if (!metadata.counter) metadata.counter = frame.number;
  if (!metadata.time_s) metadata.time_s = frame.time_s;
  return metadata;
}

}  // namespace

Recorded record(Camera& camera, std::size_t frames, const CaptureWriter& writer, const Progress& progress) {
  if (frames == 0) throw UsageError("--frames", "0 is out of range", "give 1 or more");
  const std::size_t in_flight = 2UL * std::max(1U, std::thread::hardware_concurrency());
  // Its destructor waits for all, so that none outlives the writer when something throws.
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
    writer.write_metadata(number, metadata_of(frame));
    queue.push_back(std::async(
        std::launch::async, [&writer, number, frame = std::move(frame)] { write(writer, number, frame); }));
    ++recorded.frames;
    if (progress) progress("recording", number + 1, frames);
  }
  for (std::future<void>& written : queue) written.get();
  return recorded;
}

}  // namespace rva
