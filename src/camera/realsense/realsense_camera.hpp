// A RealSense camera of a given librealsense context; separate from realsense.hpp so that tests can pass a
// context of their own.
#pragma once

#include <cstdint>
#include <librealsense2/rs.hpp>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"

namespace rva {

/// A RealSense camera, opened by its serial number.
class RealSenseCamera : public Camera {
 public:
  /// @param silence_s time without a frame after which the camera is taken to be disconnected
  /// @throws UsageError, Error as open_realsense()
  RealSenseCamera(rs2::context context, std::string serial, const RealSenseOptions& options,
                  double silence_s = 5.0);
  ~RealSenseCamera() override;
  RealSenseCamera(const RealSenseCamera&) = delete;
  RealSenseCamera& operator=(const RealSenseCamera&) = delete;

  [[nodiscard]] CaptureInfo info() const override;
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  void drop_waiting() override;
  [[nodiscard]] std::optional<ExposureControl> exposure_control() const override { return exposure_; }
  void set_exposure(const Exposure& exposure) override;

 private:
  void open();
  void close();
  [[nodiscard]] bool is_there() const;
  [[nodiscard]] rs2::frameset next_frameset();
  [[nodiscard]] FrameMetadata metadata_of(const rs2::depth_frame& depth);
  void count(std::uint64_t device_number);

  rs2::context context_;
  std::string serial_;
  RealSenseOptions options_;
  double silence_s_;
  rs2::frame_queue queue_;
  std::optional<rs2::pipeline> pipeline_;  // empty while disconnected
  rs2::sensor depth_sensor_;
  int rate_hz_ = 0;                          // of the open pipeline
  std::optional<ExposureControl> exposure_;  // as read back last
  std::optional<Exposure> chosen_exposure_;  // since the camera was opened first; set again when reopened
  mutable std::mutex mutex_;                 // guards the next
  CaptureInfo info_;
  std::uint64_t number_ = 0;                      // of the last frame returned
  std::optional<std::uint64_t> device_number_{};  // its number by the camera's counter
  double last_frame_s_ = 0.0;
  std::optional<double> temperature_c_{};
};

/// The cameras of a context. @throws Error when none can be opened although one is plugged in
[[nodiscard]] std::vector<FoundCamera> cameras_of(const rs2::context& context);

}  // namespace rva
