#include "capture/frame_reader.hpp"

#include <algorithm>
#include <cassert>
#include <deque>
#include <future>
#include <thread>

#include "core/interrupt.hpp"

namespace rva {

void for_each_depth_frame(const Capture& capture, std::size_t count, const Progress& progress,
                          const std::function<void(const DepthImage&)>& use) {
  assert(count <= capture.depth_frames());
  // Each frame in flight has a decoding thread. With twice as many threads as cores, the cores stay busy
  // while the first frame of the queue is awaited.
  const std::size_t in_flight = 2UL * std::max(1U, std::thread::hardware_concurrency());
  std::deque<std::future<DepthImage>> queue;
  std::size_t started = 0;
  for (std::size_t done = 0; done < count; ++done) {
    throw_if_interrupted();
    for (; started < count && queue.size() < in_flight; ++started) {
      queue.push_back(std::async(std::launch::async, [&capture, i = started] { return capture.depth(i); }));
    }
    const DepthImage frame = queue.front().get();
    queue.pop_front();
    use(frame);
    if (progress) progress("reading frames", done + 1, count);
  }
}

}  // namespace rva
