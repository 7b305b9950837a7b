// A recording as a Capture, read without librealsense and without ROS.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "capture/formats.hpp"
#include "capture/mcap/mcap_recording.hpp"
#include "capture/recording/described_capture.hpp"
#include "capture/recording/streams.hpp"
#include "capture/rosbag1/bag_recording.hpp"
#include "capture/rosbag2/db3_recording.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

/// The companion of each depth frame among `others`: the message nearest in time, if the depth frame is in
/// turn the nearest to that message.
std::vector<std::optional<RecordedMessage>> companions(const std::vector<RecordedMessage>& depth,
                                                       const std::vector<RecordedMessage>& others) {
  const auto nearest = [](const std::vector<RecordedMessage>& among, std::uint64_t time_ns) {
    const auto distance = [&](const RecordedMessage& message) {
      return message.time_ns > time_ns ? message.time_ns - time_ns : time_ns - message.time_ns;
    };
    auto after = std::ranges::lower_bound(among, time_ns, {}, &RecordedMessage::time_ns);
    if (after == among.end() || (after != among.begin() && distance(*(after - 1)) <= distance(*after)))
      --after;
    return after;
  };
  std::vector<std::optional<RecordedMessage>> found(depth.size());
  if (others.empty()) return found;
  for (auto frame = depth.begin(); frame != depth.end(); ++frame) {
    const auto other = nearest(others, frame->time_ns);
    if (nearest(depth, other->time_ns) == frame)
      found[static_cast<std::size_t>(frame - depth.begin())] = *other;
  }
  return found;
}

class RecordedCapture : public Capture {
 public:
  /// @param stated_unit_m depth unit that the recording states, metres: every frame must have it
  /// @param described     whether RVA wrote the recording
  RecordedCapture(std::unique_ptr<Recording> recording, CaptureInfo info, RecordedStreams streams,
                  double stated_unit_m, bool described)
      : Capture(std::move(info)),
        stated_unit_m_(stated_unit_m),
        described_(described),
        recording_(std::move(recording)),
        streams_(std::move(streams)),
        depth_(recording_->messages(streams_.depth.images())),
        no_depth_(this->info().no_depth, this->info().depth_unit_m) {
    if (streams_.color) color_ = recording_->messages(streams_.color->images());
    color_of_ = companions(depth_, color_);
    for (const auto& [imager, stream] : streams_.infrared)
      infrared_of_[imager] = companions(depth_, recording_->messages(stream.images()));
  }

  [[nodiscard]] std::size_t depth_frames() const override { return depth_.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return color_.size(); }

  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    DepthImage image = stored_depth(i);
    no_depth_.clear(image, [this] { return stored_depth(0); });
    return image;
  }

  [[nodiscard]] std::vector<std::string> depth_notes() const override {
    return no_depth_.notes([this] { return stored_depth(0); });
  }

  [[nodiscard]] bool marks_no_depth_by_zero() const override {
    return no_depth_.are_zero([this] { return stored_depth(0); });
  }

  [[nodiscard]] ColorImage color(std::size_t i) const override {
    return read_color(color_.at(i), source("colour", i));
  }

  [[nodiscard]] std::optional<ColorImage> color_of(std::size_t depth_frame) const override {
    const auto& message = color_of_.at(depth_frame);
    return message ? std::optional(read_color(*message, source("colour of depth", depth_frame)))
                   : std::nullopt;
  }

  [[nodiscard]] std::optional<FineGrayImage> infrared_of(std::size_t depth_frame,
                                                         Imager imager) const override {
    const auto stream = streams_.infrared.find(imager);
    if (stream == streams_.infrared.end()) return std::nullopt;
    std::optional<RecordedMessage> message = infrared_of_.at(imager).at(depth_frame);
    if (!message && is_mean_of_frames(stream->second))
      message = recording_->messages(stream->second.images()).front();
    if (!message) return std::nullopt;
    return read_infrared(stream->second, *message, source("infrared of depth", depth_frame));
  }

  [[nodiscard]] bool has_infrared(Imager imager, Light light) const override {
    return streams_under(light).contains(imager);
  }

  [[nodiscard]] std::optional<Image<float>> infrared_mean(Imager imager, Light light) const override {
    if (light == Light::projector) return Capture::infrared_mean(imager, light);
    const auto stream = streams_.lamp.find(imager);
    if (stream == streams_.lamp.end()) return std::nullopt;
    const FineGrayImage image =
        read_infrared(stream->second, recording_->messages(stream->second.images()).front(),
                      fmt::format("{}, infrared under the lamp", recording_->source()));
    Image<float> levels(image.width(), image.height());
    std::ranges::transform(image.pixels(), levels.pixels().begin(), [](std::uint16_t fine) {
      return static_cast<float>(fine) / static_cast<float>(fine_steps_per_grey_level);
    });
    return levels;
  }

  [[nodiscard]] FrameMetadata metadata_of(std::size_t depth_frame) const override {
    const RecordedMessage& message = depth_.at(depth_frame);
    if (!described_) return rva::metadata_of(*recording_, streams_.depth, message);
    const auto stated = recording_->messages_at(recorded_topic::frame, message.time_ns);
    if (stated.empty()) return {};
    const auto lines = parse_frame_lines(recording_->text(stated.front(), recorded_topic::frame),
                                         source("description of depth", depth_frame));
    return lines.empty() ? FrameMetadata{} : lines.begin()->second;
  }

 private:
  [[nodiscard]] const std::map<Imager, RecordedStream>& streams_under(Light light) const {
    return light == Light::lamp ? streams_.lamp : streams_.infrared;
  }

  // Recordings that RVA wrote may have one infrared image for all frames.
  [[nodiscard]] bool is_mean_of_frames(const RecordedStream& stream) const {
    return info().infrared && info().infrared->frames > 1 &&
           recording_->messages(stream.images()).size() == 1;
  }

  [[nodiscard]] FineGrayImage read_infrared(const RecordedStream& stream, const RecordedMessage& message,
                                            const std::string& where) const {
    const ImageMessage stored = recording_->image(stream, message, where);
    if (stored.width != info().depth.width || stored.height != info().depth.height)
      throw Error(where, "its size differs from that of the depth images", "record it again");
    return described_ ? fine_gray_of(stored, where) : fine_gray(gray_of(stored, where));
  }

  [[nodiscard]] DepthImage stored_depth(std::size_t i) const {
    const std::string where = source("depth", i);
    const ImageMessage image = recording_->image(streams_.depth, depth_.at(i), where);
    if (image.width != info().depth.width || image.height != info().depth.height) {
      throw Error(where,
                  fmt::format("has {}x{} pixels, but the file states {}x{}", image.width, image.height,
                              info().depth.width, info().depth.height),
                  "record it again");
    }
    if (image.unit_m && *image.unit_m != stated_unit_m_)
      throw Error(where, "its depth unit differs from that of the first frame", "record it again");
    return rva::depth_of(image, info().depth_unit_m, where);
  }

  [[nodiscard]] std::string source(const char* kind, std::size_t i) const {
    return fmt::format("{}, {} frame {}", recording_->source(), kind, i);
  }

  [[nodiscard]] ColorImage read_color(const RecordedMessage& message, const std::string& where) const {
    return rva::color_of(recording_->image(*streams_.color, message, where), where);
  }

  double stated_unit_m_;
  bool described_;
  std::unique_ptr<Recording> recording_;
  RecordedStreams streams_;
  std::vector<RecordedMessage> depth_;
  NoDepthValues no_depth_;
  std::vector<RecordedMessage> color_;
  std::vector<std::optional<RecordedMessage>> color_of_;                       // by depth frame
  std::map<Imager, std::vector<std::optional<RecordedMessage>>> infrared_of_;  // the same
};

}  // namespace

std::unique_ptr<Capture> open_recording(const std::filesystem::path& file, const CaptureOptions& options) {
  std::unique_ptr<Recording> recording = is_db3_file(file)    ? open_db3_recording(file)
                                         : is_mcap_file(file) ? open_mcap_recording(file)
                                                              : open_bag_recording(file);
  const bool described = !options.topic && is_described(*recording);
  RecordedStreams streams =
      described ? described_streams(*recording) : find_streams(*recording, options.topic);
  CaptureInfo info = described ? described_info(*recording, options.intrinsics)
                               : describe(*recording, streams, options.intrinsics);
  require_possible(info, recording->source());
  const double stated_unit_m = info.depth_unit_m;
  info.no_depth.insert(info.no_depth.end(), options.no_depth.begin(), options.no_depth.end());
  settle_unit(options, info);
  return std::make_unique<RecordedCapture>(std::move(recording), std::move(info), std::move(streams),
                                           stated_unit_m, described);
}

}  // namespace rva
