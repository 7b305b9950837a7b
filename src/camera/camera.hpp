// The interface of every camera: a device, a simulation or a recording.
#pragma once

#include <cassert>
#include <cstdint>
#include <map>
#include <optional>

#include "camera/exposure.hpp"
#include "capture/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// The images that a camera took at one moment.
struct CameraFrame {
  DepthImage depth;                 ///< of the size and unit that info() states; 0 is no measurement
  std::optional<ColorImage> color;  ///< of the size that info().color states; empty where there is none
  std::uint64_t number = 0;         ///< increases by one per frame; a gap means lost frames
  double time_s = 0.0;              ///< when depth was exposed, by the camera's clock; for differences
  std::map<Imager, FineGrayImage> infrared{};  ///< of the imagers whose images the camera provides
  FrameMetadata metadata{};                    ///< stated by the device; of a replayed frame, as recorded
};

/// A stream of frames.
///
/// A returned frame belongs to the caller. wait_for_frame() must be called by one thread at a time; info()
/// may be called from any. Constructors open a camera, destructors close it.
class Camera {
 public:
  Camera() = default;
  virtual ~Camera() = default;
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  /// The current description of the frames, by value since the pose of a camera on a robot changes. It
  /// becomes the description of a recording. `captured_at` and `source_json` are those of a replayed capture,
  /// otherwise empty.
  [[nodiscard]] virtual CaptureInfo info() const = 0;

  /// Waits for the next frame. If the caller is late, a device drops the oldest frames; a recording does not.
  /// @return empty at the end of a recording and in all later calls; a device or a simulation has no end
  /// @throws Error       when the device failed or gave no frame, or the recording is damaged; the call may
  ///                     be repeated
  /// @throws Interrupted when the user stopped the program meanwhile
  [[nodiscard]] virtual std::optional<CameraFrame> wait_for_frame() = 0;

  /// Whether the camera has a lamp beside its imagers; for a recording, whether it has images under a lamp.
  [[nodiscard]] virtual bool has_lamp() const { return false; }

  /// Selects the light for the next frames, which is the projector at first. Frames under the lamp serve for
  /// their infrared images: their depth is meaningless.
  /// @param light may be the lamp only if has_lamp()
  virtual void set_light([[maybe_unused]] Light light) { assert(light == Light::projector); }

  /// The exposure of the infrared imagers; empty where it cannot be set. Called by the thread that waits for
  /// frames.
  [[nodiscard]] virtual std::optional<ExposureControl> exposure_control() const { return std::nullopt; }

  /// Sets the exposure for the next frames. Called by the thread that waits for frames, only if
  /// exposure_control() is not empty.
  /// @param exposure within exposure_control(); a device rounds it to its own steps
  /// @throws Error when the device refuses it
  virtual void set_exposure([[maybe_unused]] const Exposure& exposure) { assert(false); }

  /// Drops frames that are waiting, so that the next one is exposed after this call. A camera that produces
  /// frames on request has none waiting.
  virtual void drop_waiting() {}
};

}  // namespace rva
