// What every camera does, whether it is a device, a simulation or a recording.
#pragma once

#include <cassert>
#include <cstdint>
#include <map>
#include <optional>

#include "depth/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// What a camera saw at one moment.
struct CameraFrame {
  DepthImage depth;                 ///< of the size and unit that info() states; 0 is no measurement
  std::optional<ColorImage> color;  ///< of the size that info().color states; empty where there is none
  std::uint64_t number = 0;         ///< counts up by one; a gap is frames that were lost
  double time_s = 0.0;              ///< when the depth was exposed, by the camera's clock: for differences
  std::map<Imager, FineGrayImage> infrared{};  ///< of the imagers that the camera gives images of
  FrameMetadata metadata{};  ///< what the device says besides; of a replayed frame, what it said then
};

/// A stream of frames.
///
/// A frame belongs to the caller; the camera keeps nothing of it. wait_for_frame() is for one thread at a
/// time; info() may be called from any. Opening a camera is its constructor's, closing its destructor's.
class Camera {
 public:
  Camera() = default;
  virtual ~Camera() = default;
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  /// The view that frames have now, by value since the pose of a camera on a robot changes. A recording gets
  /// its description from this; `captured_at` and `source_json` are those of a replayed capture, else empty.
  [[nodiscard]] virtual CaptureInfo info() const = 0;

  /// Waits for the next frame. A device drops the oldest frames when nobody asks for long; a recording waits.
  /// @return empty at the end of a recording, and ever after; a device or a simulation has no end
  /// @throws Error       when the device failed or stayed silent, or the recording is damaged; the camera is
  ///                     as before, and asking again is allowed
  /// @throws Interrupted when a person stopped the program meanwhile
  [[nodiscard]] virtual std::optional<CameraFrame> wait_for_frame() = 0;

  /// Whether it has a lamp beside its imagers, or, of a recording, images under one.
  [[nodiscard]] virtual bool has_lamp() const { return false; }

  /// What lights the next frames; the projector does at first. Frames under the lamp are for their infrared
  /// images: their depth means nothing.
  /// @param light the lamp only where has_lamp()
  virtual void set_light([[maybe_unused]] Light light) { assert(light == Light::projector); }

  /// Forgets frames that wait: the next one is exposed after this call. A camera that makes its frames when
  /// they are asked for has none waiting.
  virtual void drop_waiting() {}
};

}  // namespace rva
