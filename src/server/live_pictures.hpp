// The camera's newest frame as pictures, made once however many look.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "camera/live_camera.hpp"
#include "depth/colorize.hpp"

namespace rva {

enum class Stream { color, depth, infrared };
inline constexpr std::array all_streams{Stream::color, Stream::depth, Stream::infrared};
[[nodiscard]] std::string_view name_of(Stream stream);
[[nodiscard]] std::optional<Stream> stream_from_name(std::string_view name);

/// A frame as a JPEG.
struct LivePicture {
  Stream stream = Stream::color;
  std::uint64_t number = 0;  ///< the camera's own
  int width = 0;
  int height = 0;
  std::chrono::system_clock::time_point taken_at;
  std::optional<ColorScale> scale_m;  ///< of depth: what the colours stand for
  std::vector<std::byte> jpeg;
};

/// Encodes on a thread of its own, and only what somebody looks at. Never more than the newest frame waits.
/// Every member may be called from any thread.
class LivePictures {
 public:
  using Listener = std::function<void(std::shared_ptr<const LivePicture>)>;

  /// @param listener called with each picture, on the thread that encodes: it must be quick
  LivePictures(const LiveCamera& camera, Listener listener);

  /// How many look at a stream; none: it is not encoded.
  void watch(Stream stream, int change);

  /// What the camera's frames bring.
  [[nodiscard]] std::vector<Stream> streams() const;

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<const LivePicture> encode(const LiveFrame& live, Stream stream);
  [[nodiscard]] ColorImage colorized(const LiveFrame& live);

  const LiveCamera& camera_;
  Listener listener_;
  std::array<std::atomic<int>, all_streams.size()> watchers_{};
  std::optional<ColorScale> scale_m_;
  std::uint64_t scale_number_ = 0;  // of the frame that the scale is of
  std::jthread thread_;             // last: it uses all above
};

}  // namespace rva
