// The camera's newest frame as pictures, encoded once for all consoles.
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
#include <thread>
#include <vector>

#include "camera/live_camera.hpp"
#include "core/enum_names.hpp"
#include "depth/colorize.hpp"

namespace rva {

/// The streams that the console displays.
enum class Stream { color, depth, infrared };
template <>
inline constexpr auto enum_names<Stream> = std::to_array<EnumName<Stream>>({
    {Stream::color, "color"},
    {Stream::depth, "depth"},
    {Stream::infrared, "infrared"},
});

/// A frame as a JPEG.
struct LivePicture {
  Stream stream = Stream::color;
  std::uint64_t number = 0;  ///< of the camera's frame
  int width = 0;
  int height = 0;
  std::chrono::system_clock::time_point taken_at;
  std::optional<ColorScale> scale_m;  ///< range of the colours; only for depth
  std::vector<std::byte> jpeg;
};

/// Whether a frame has an image of this stream; colour may be missing in some frames of a camera that has it.
[[nodiscard]] bool has_picture(const LiveFrame& live, Stream stream);

/// A frame of a stream as a picture; depth in colours.
/// @throws Error when the frame has no image of this stream
[[nodiscard]] ColorImage picture_of(const LiveFrame& live, Stream stream);

/// Encodes on a thread of its own, and only streams that somebody watches. Only the newest frame waits to be
/// encoded. Every member may be called from any thread.
class LivePictures {
 public:
  /// Is called with each picture.
  using Listener = std::function<void(std::shared_ptr<const LivePicture>)>;

  /// @param listener called with each picture, on the thread that encodes: it must be quick
  LivePictures(const LiveCamera& camera, Listener listener);

  /// Changes the number of viewers of a stream. A stream without viewers is not encoded.
  void watch(Stream stream, int change);

  /// The streams that the camera provides.
  [[nodiscard]] std::vector<Stream> streams() const;

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<const LivePicture> encode(const LiveFrame& live, Stream stream);
  [[nodiscard]] ColorImage colorized(const LiveFrame& live);

  const LiveCamera& camera_;
  Listener listener_;
  std::array<std::atomic<int>, enum_names<Stream>.size()> watchers_{};
  std::optional<ColorScale> scale_m_;
  std::uint64_t scale_number_ = 0;  // of the frame from which the scale was computed
  std::jthread thread_;             // last: it uses all above
};

}  // namespace rva
