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
}

}  // namespace

void record(Camera& camera, std::size_t frames, const CaptureWriter& writer, const Progress& progress) {
  if (frames == 0) throw UsageError("--frames", "0 is out of range", "give 1 or more");
  const std::size_t in_flight = 2UL * std::max(1U, std::thread::hardware_concurrency());
  // Its destructor waits for all, so that none outlives the writer when something throws.
  std::deque<std::future<void>> queue;
  for (std::size_t number = 0; number < frames; ++number) {
    if (queue.size() == in_flight) {
      queue.front().get();
      queue.pop_front();
    }
    queue.push_back(std::async(
        std::launch::async,
        [&writer, number, frame = next_frame(camera, number, frames)] { write(writer, number, frame); }));
    if (progress) progress("recording", number + 1, frames);
  }
  for (std::future<void>& written : queue) written.get();
}

}  // namespace rva
