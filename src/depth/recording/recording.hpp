// What librealsense's recorders keep of a camera, whichever kind of file holds it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "depth/recording/image_message.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Where a message lies, and when it was recorded.
struct RecordedMessage {
  std::uint64_t time_ns = 0;  ///< since the recording began; 0 also for what was so before
  std::uint64_t at = 0;       ///< byte of the file where its chunk begins, or row of the database
  std::uint32_t offset = 0;   ///< in the chunk as it is unpacked
};

/// One stream of messages.
struct RecordedTopic {
  std::string type;                       ///< "sensor_msgs/Image"
  std::vector<RecordedMessage> messages;  ///< in the order of their times
};

/// By name: "/device_0/sensor_0/Depth_0/image/data".
using RecordedTopics = std::map<std::string, RecordedTopic, std::less<>>;

using KeyValues = std::map<std::string, std::string>;

/// The topics of one imager begin with these, as librealsense records them; ROS states each by itself.
struct RecordedStream {
  std::string sensor;             ///< "/device_0/sensor_0/"
  std::string name;               ///< "/device_0/sensor_0/Depth_0"
  std::string ros_images{};       ///< "/camera/depth/image_rect_raw"; empty in recordings of librealsense
  std::string ros_camera_info{};  ///< "/camera/depth/camera_info"; likewise

  [[nodiscard]] bool is_of_ros() const { return !ros_images.empty(); }
  [[nodiscard]] std::string images() const { return is_of_ros() ? ros_images : name + "/image/data"; }
  [[nodiscard]] std::string metadata() const { return name + "/image/metadata"; }
};

/// A file of a recorder. Memory holds where messages are, not the messages. Const members may be called from
/// several threads; all throw Error where the file is damaged.
class Recording {
 public:
  Recording() = default;
  virtual ~Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  /// "bag", "db3"
  [[nodiscard]] virtual std::string_view format() const = 0;

  /// What to call it in an error.
  [[nodiscard]] virtual const std::string& place() const = 0;

  [[nodiscard]] virtual const RecordedTopics& topics() const = 0;

  /// What a person should know of the file; sentences without full stop.
  [[nodiscard]] virtual std::vector<std::string> notes() const = 0;

  /// @param message of stream.images()
  /// @param place   what to call it in an error
  [[nodiscard]] virtual ImageMessage image(const RecordedStream& stream, const RecordedMessage& message,
                                           std::string_view place) const = 0;

  /// What the camera says of an image, by librealsense's names: "Actual Exposure".
  [[nodiscard]] virtual KeyValues metadata(const RecordedStream& stream,
                                           const RecordedMessage& image) const = 0;

  /// What a device or a sensor says of itself: "Name", "Serial Number". Empty where it says nothing.
  /// @param topic "/device_0/info"
  [[nodiscard]] virtual KeyValues info(const std::string& topic) const = 0;

  /// As they were when the recording began, by librealsense's names: "Laser Power".
  /// @param sensor "/device_0/sensor_0/"
  [[nodiscard]] virtual std::map<std::string, double> settings(const std::string& sensor) const = 0;

  [[nodiscard]] virtual Intrinsics intrinsics(const RecordedStream& stream) const = 0;

  /// This stream's frame from those that it shares with others, by what these are called.
  [[nodiscard]] virtual std::map<std::string, Transform> stream_from_groups(
      const RecordedStream& stream) const = 0;

  /// The messages of a topic; none where there is no such topic.
  [[nodiscard]] const std::vector<RecordedMessage>& messages(std::string_view topic) const;

  /// Those that a topic has at the very time of an image: they are about it.
  [[nodiscard]] std::vector<RecordedMessage> messages_at(std::string_view topic, std::uint64_t time_ns) const;

  /// The first message of each topic that begins so, and the rest of its name: "option/" gives
  /// "Laser_Power/value".
  void for_each_below(const std::string& beginning,
                      const std::function<void(std::string_view, const RecordedMessage&)>& use) const;
};

/// A recording without the topic that has an imager's intrinsics.
[[nodiscard]] Error lacks_intrinsics(const std::string& place, const std::string& topic);

/// A finite number, written as decimals; none for anything else.
[[nodiscard]] std::optional<double> decimal_number(std::string_view text);

/// A setting's name from the end of its topic: "Laser_Power/value" gives "Laser Power"; none for others.
[[nodiscard]] std::optional<std::string> setting_of(std::string_view below_options);

/// Completes intrinsics by the lens model as librealsense names it. One that we do not know is none where its
/// coefficients are 0.
/// @throws Error when no camera can have these, or the model is not known
[[nodiscard]] Intrinsics with_lens(Intrinsics camera, std::string_view model,
                                   const std::vector<double>& coefficients, std::string_view place);

}  // namespace rva
