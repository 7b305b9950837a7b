// Recordings of a camera by librealsense or ROS, independent of the file format.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/recording/image_message.hpp"
#include "capture/recording/static_transforms.hpp"
#include "core/error.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// The position of a message, and when it was recorded.
struct RecordedMessage {
  std::uint64_t time_ns = 0;  ///< recording time; 0 for what was recorded before the start
  std::uint64_t at = 0;       ///< byte of the file where its chunk begins, or row of the database
  std::uint32_t offset = 0;   ///< in the decompressed chunk
};

/// One stream of messages.
struct RecordedTopic {
  std::string type;                       ///< "sensor_msgs/Image"
  std::vector<RecordedMessage> messages;  ///< in order of time
};

/// Topics by name: "/device_0/sensor_0/Depth_0/image/data".
using RecordedTopics = std::map<std::string, RecordedTopic, std::less<>>;

/// Values as text, by name.
using KeyValues = std::map<std::string, std::string>;

/// The topics of one imager. In recordings of librealsense they have a common beginning; ROS names
/// each separately.
struct RecordedStream {
  std::string sensor;             ///< "/device_0/sensor_0/"
  std::string name;               ///< "/device_0/sensor_0/Depth_0"
  std::string ros_images{};       ///< "/camera/depth/image_rect_raw"; empty in recordings of librealsense
  std::string ros_camera_info{};  ///< "/camera/depth/camera_info"; likewise

  /// Whether topics are named as in ROS, not as in recordings of librealsense.
  [[nodiscard]] bool is_of_ros() const { return !ros_images.empty(); }
  /// The topic of the images.
  [[nodiscard]] std::string images() const { return is_of_ros() ? ros_images : name + "/image/data"; }
  /// The topic of the images' metadata in recordings of librealsense.
  [[nodiscard]] std::string metadata() const { return name + "/image/metadata"; }
};

/// A recording in a file. The positions of messages are kept in memory, not the messages. Const members may
/// be called from several threads. All members throw Error where the file is damaged.
class Recording {
 public:
  Recording() = default;
  virtual ~Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  /// "bag", "db3" or "mcap".
  [[nodiscard]] virtual std::string_view format() const = 0;

  /// The file's name, for errors.
  [[nodiscard]] virtual const std::string& source() const = 0;

  /// All topics of the recording.
  [[nodiscard]] virtual const RecordedTopics& topics() const = 0;

  /// Remarks on the file for the user; sentences without a full stop.
  [[nodiscard]] virtual std::vector<std::string> notes() const = 0;

  /// Reads and parses an image.
  /// @param message of stream.images()
  /// @param source   name of the image, for errors
  [[nodiscard]] virtual ImageMessage image(const RecordedStream& stream, const RecordedMessage& message,
                                           std::string_view source) const = 0;

  /// Metadata of an image, by librealsense's names: "Actual Exposure".
  [[nodiscard]] virtual KeyValues metadata(const RecordedStream& stream,
                                           const RecordedMessage& image) const = 0;

  /// Information on a device or a sensor: "Name", "Serial Number". Empty where there is none.
  /// @param topic "/device_0/info"
  [[nodiscard]] virtual KeyValues info(const std::string& topic) const = 0;

  /// Settings at the start of the recording, by librealsense's names: "Laser Power".
  /// @param sensor "/device_0/sensor_0/"
  [[nodiscard]] virtual std::map<std::string, double> settings(const std::string& sensor) const = 0;

  /// The intrinsics of the stream's images, with their distortion model (with_lens()).
  [[nodiscard]] virtual Intrinsics intrinsics(const RecordedStream& stream) const = 0;

  /// Transforms from the frames that the stream shares with others to its own frame, by the names of
  /// the former.
  [[nodiscard]] virtual std::map<std::string, Transform> stream_from_groups(
      const RecordedStream& stream) const = 0;

  /// The messages of /tf_static. Empty where there are none.
  [[nodiscard]] virtual std::vector<StaticTransform> static_transforms() const { return {}; }

  /// The text of a JSON message of one of the topics of described_capture.hpp, in recordings that RVA wrote;
  /// empty in others.
  [[nodiscard]] virtual std::string text(const RecordedMessage& /*message*/,
                                         std::string_view /*topic*/) const {
    return {};
  }

  /// Whether the images of a topic are compressed (compressed_image.hpp).
  [[nodiscard]] bool is_compressed(std::string_view topic) const;

  /// The messages of a topic; empty where there is no such topic.
  [[nodiscard]] const std::vector<RecordedMessage>& messages(std::string_view topic) const;

  /// The messages of a topic with exactly the time of an image, and hence about that image.
  [[nodiscard]] std::vector<RecordedMessage> messages_at(std::string_view topic, std::uint64_t time_ns) const;

  /// Calls `use` with each topic whose name has this beginning: with the rest of the name
  /// ("Laser_Power/value" for a beginning that ends in "option/") and its first message.
  void for_each_below(const std::string& beginning,
                      const std::function<void(std::string_view, const RecordedMessage&)>& use) const;
};

/// The transforms of several messages. @param parse returns those of one
[[nodiscard]] std::vector<StaticTransform> transforms_of(
    const std::vector<RecordedMessage>& messages,
    const std::function<std::vector<StaticTransform>(const RecordedMessage&)>& parse);

/// The error for a recording without the topic that has an imager's intrinsics.
[[nodiscard]] Error lacks_intrinsics(const std::string& source, const std::string& topic);

/// Parses a finite decimal number; empty for anything else.
[[nodiscard]] std::optional<double> decimal_number(std::string_view text);

/// A setting's name from the end of its topic: "Laser Power" from "Laser_Power/value"; empty for others.
[[nodiscard]] std::optional<std::string> setting_of(std::string_view below_options);

/// Completes intrinsics by the distortion model, as librealsense or ROS name it. An unknown model is accepted
/// as no distortion if its coefficients are all 0.
/// @throws Error when the intrinsics are impossible, or the model is unknown
[[nodiscard]] Intrinsics with_lens(Intrinsics camera, std::string_view model,
                                   const std::vector<double>& coefficients, std::string_view source);

}  // namespace rva
