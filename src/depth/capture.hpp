// A capture: what one camera saw from one place, as files hold it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Where the camera stood. Captures whose `base` agree share one world frame.
struct Pose {
  std::optional<std::string> base;
  std::optional<double> pan_deg;
  std::optional<double> tilt_deg;
  std::optional<Transform> world_from_camera;
};

/// Which camera it was.
struct CameraInfo {
  std::string model;
  std::string serial;
  std::optional<double> baseline_m;  ///< distance between the two imagers of a stereo camera
};

/// What is known of a capture besides its images.
struct CaptureInfo {
  std::string format;  ///< "rva-capture", "open3d", "tum"
  Intrinsics depth;
  double depth_unit_m = 0.001;  ///< metres of one step of a depth image
  std::optional<Intrinsics> color;
  std::optional<Transform> color_from_depth;
  std::optional<Pose> pose;
  std::optional<CameraInfo> camera;
  std::string captured_at;  ///< ISO 8601, empty where unknown
  std::string source_json;  ///< the description as it was read, keys that we do not know included
};

/// Frames and their description, whoever recorded them. Reading is const and may run on several threads.
class Capture {
 public:
  explicit Capture(CaptureInfo info) : info_(std::move(info)) {}
  virtual ~Capture() = default;
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  [[nodiscard]] const CaptureInfo& info() const { return info_; }
  [[nodiscard]] virtual std::size_t depth_frames() const = 0;
  [[nodiscard]] virtual std::size_t color_frames() const = 0;

  /// @param i frame, from 0, below depth_frames()
  /// @return  an image of the size that info().depth states
  /// @throws  Error when the frame is damaged or of another size
  [[nodiscard]] virtual DepthImage depth(std::size_t i) const = 0;

  /// As depth(); the image has the size that info().color states, if it states one.
  [[nodiscard]] virtual ColorImage color(std::size_t i) const = 0;

 private:
  CaptureInfo info_;
};

/// What a capture's own files may leave out.
struct CaptureOptions {
  /// Intrinsics for a format that carries none (TUM); the size is that of the first image.
  std::optional<Intrinsics> intrinsics;
};

/// Opens a capture folder, an Open3D recorder folder or a TUM RGB-D folder, told apart by the files in it.
/// Images are not read yet.
/// @throws Error when it is none of these, its description is missing or malformed, or it has no depth frame
[[nodiscard]] std::unique_ptr<Capture> open_capture(const std::filesystem::path& path,
                                                    const CaptureOptions& options = {});

}  // namespace rva
