// Writes a capture as an MCAP file that ROS 2, Foxglove and other readers of MCAP show, and that is read back
// exactly.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "capture/capture_sink.hpp"
#include "capture/mcap/mcap_writer.hpp"
#include "capture/mcap/ros2_messages.hpp"

namespace rva {

/// Images are sensor_msgs/Image: depth in 16UC1 where the unit is 1 mm, else in 32FC1 (metres), as REP 118
/// has it; colour in rgb8; infrared in mono16, in 256ths of a grey level. Their intrinsics, the transform to
/// the colour imager and the pose are there as CameraInfo and TFMessage. What ROS has no message for is in
/// JSON messages (recording/described_capture.hpp).
class McapCaptureWriter : public CaptureSink {
 public:
  /// @param file              is created or replaced; give a temporary name, and rename it after finish()
  /// @param extra_json_object as for capture_json()
  /// @throws Error when the file cannot be created, or the description is impossible
  McapCaptureWriter(const std::filesystem::path& file, const CaptureInfo& info,
                    std::string extra_json_object = "{}");

  void write_metadata(std::size_t number, const FrameMetadata& metadata) override;
  void write_depth(std::size_t number, const DepthImage& image) override;
  void write_color(std::size_t number, const ColorImage& image) override;
  void write_infrared(Imager imager, Light light, const FineGrayImage& mean,
                      const InfraredBurst& burst) override;
  /// Writes the infrared image of one frame, of a recording that has one for each.
  void write_infrared_of(std::size_t number, Imager imager, const FineGrayImage& image);

  /// Completes the file. @throws Error when the disk is full or refuses
  void finish();

 private:
  [[nodiscard]] std::uint64_t time_of(std::size_t number);
  [[nodiscard]] McapWriter::Id channel(std::string_view topic, const MessageType& type);
  void write_description();
  void write_transforms();
  void write_image(std::size_t number, std::string_view topic, std::string_view frame, const RawImage& image,
                   const Intrinsics* camera);

  CaptureInfo info_;
  std::string extra_json_object_;
  std::uint64_t start_ns_;
  std::mutex mutex_;  // guards the following
  McapWriter file_;
  std::map<std::string, McapWriter::Id, std::less<>> schemas_;
  std::map<std::string, McapWriter::Id, std::less<>> channels_;
  std::map<std::size_t, std::uint64_t> times_ns_;
  std::optional<double> first_time_s_;
};

}  // namespace rva
