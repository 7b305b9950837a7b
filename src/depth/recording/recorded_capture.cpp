// A .bag as realsense-viewer and librealsense's recorder write it, without librealsense.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "depth/bag/bag_file.hpp"
#include "depth/bag/bag_streams.hpp"
#include "depth/bag/realsense_messages.hpp"
#include "depth/formats.hpp"

namespace rva {
namespace {

/// Where each depth frame's companion lies among `others`: the one nearest in time, if that depth frame is in
/// turn the nearest to it.
std::vector<std::optional<BagMessage>> companions(const std::vector<BagMessage>& depth,
                                                  const std::vector<BagMessage>& others) {
  const auto nearest = [](const std::vector<BagMessage>& among, std::uint64_t time_ns) {
    const auto distance = [&](const BagMessage& message) {
      return message.time_ns > time_ns ? message.time_ns - time_ns : time_ns - message.time_ns;
    };
    auto after = std::ranges::lower_bound(among, time_ns, {}, &BagMessage::time_ns);
    if (after == among.end() || (after != among.begin() && distance(*(after - 1)) <= distance(*after)))
      --after;
    return after;
  };
  std::vector<std::optional<BagMessage>> found(depth.size());
  if (others.empty()) return found;
  for (auto frame = depth.begin(); frame != depth.end(); ++frame) {
    const auto other = nearest(others, frame->time_ns);
    if (nearest(depth, other->time_ns) == frame)
      found[static_cast<std::size_t>(frame - depth.begin())] = *other;
  }
  return found;
}

class BagCapture : public Capture {
 public:
  BagCapture(std::unique_ptr<BagFile> bag, CaptureInfo info, const BagStreams& streams)
      : Capture(std::move(info)), bag_(std::move(bag)), stream_(streams.depth) {
    depth_ = images(*bag_, stream_);
    if (streams.color) color_ = images(*bag_, *streams.color);
    color_of_ = companions(depth_, color_);
    if (streams.infrared) infrared_of_ = companions(depth_, images(*bag_, *streams.infrared));
  }

  [[nodiscard]] std::size_t depth_frames() const override { return depth_.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return color_.size(); }

  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    const std::vector<std::byte> message = bag_->read(depth_.at(i));
    const ImageMessage image = parse_image_message(message, place("depth", i));
    require_size(image, info().depth, "depth", i);
    if (image.unit_m && shortest_decimal(*image.unit_m) != info().depth_unit_m)
      throw Error(place("depth", i), "its unit is not that of the first frame", "record it again");
    return rva::depth_of(image, place("depth", i));
  }

  [[nodiscard]] ColorImage color(std::size_t i) const override {
    return read_color(color_.at(i), place("colour", i));
  }

  [[nodiscard]] std::optional<ColorImage> color_of(std::size_t depth_frame) const override {
    const auto& message = color_of_.at(depth_frame);
    return message ? std::optional(read_color(*message, place("colour of depth", depth_frame)))
                   : std::nullopt;
  }

  [[nodiscard]] std::optional<GrayImage> infrared_of(std::size_t depth_frame) const override {
    if (infrared_of_.empty() || !infrared_of_.at(depth_frame)) return std::nullopt;
    const BagMessage& message = *infrared_of_[depth_frame];
    const std::string where = place("infrared of depth", depth_frame);
    const std::vector<std::byte> bytes = bag_->read(message);
    return gray_of(parse_image_message(bytes, where), where);
  }

  [[nodiscard]] FrameMetadata metadata_of(std::size_t depth_frame) const override {
    return rva::metadata_of(*bag_, stream_, depth_.at(depth_frame));
  }

 private:
  [[nodiscard]] std::string place(const char* kind, std::size_t i) const {
    return fmt::format("{}, {} frame {}", bag_->place(), kind, i);
  }

  void require_size(const ImageMessage& image, const Intrinsics& stated, const char* kind,
                    std::size_t i) const {
    if (image.width == stated.width && image.height == stated.height) return;
    throw Error(place(kind, i),
                fmt::format("{}x{} pixels where the file states {}x{}", image.width, image.height,
                            stated.width, stated.height),
                "record it again");
  }

  [[nodiscard]] ColorImage read_color(const BagMessage& message, const std::string& where) const {
    const std::vector<std::byte> bytes = bag_->read(message);
    return rva::color_of(parse_image_message(bytes, where), where);
  }

  std::unique_ptr<BagFile> bag_;
  BagStream stream_;
  std::vector<BagMessage> depth_;
  std::vector<BagMessage> color_;
  std::vector<std::optional<BagMessage>> color_of_;
  std::vector<std::optional<BagMessage>> infrared_of_;
};

}  // namespace

std::unique_ptr<Capture> open_bag(const std::filesystem::path& file) {
  auto bag = std::make_unique<BagFile>(file);
  const BagStreams streams = find_streams(*bag);
  CaptureInfo info = describe(*bag, streams);
  require_possible(info, bag->place());
  return std::make_unique<BagCapture>(std::move(bag), std::move(info), streams);
}

}  // namespace rva
