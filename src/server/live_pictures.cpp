#include "server/live_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

constexpr int quality = 80;

std::size_t index_of(Stream stream) { return static_cast<std::size_t>(stream); }

bool brings(const CameraFrame& frame, Stream stream) {
  switch (stream) {
    case Stream::color:
      return frame.color.has_value();
    case Stream::depth:
      return true;
    case Stream::infrared:
      return frame.infrared.contains(Imager::left);
  }
  return false;
}

GrayImage grey_levels(const FineGrayImage& fine) {
  GrayImage levels(fine.width(), fine.height());
  std::ranges::transform(fine.pixels(), levels.pixels().begin(), [](auto brightness) {
    return static_cast<std::uint8_t>(brightness / fine_steps_per_grey_level);
  });
  return levels;
}

Image<float> metres(const LiveFrame& live) {
  const DepthImage& depth = live.frame.depth;
  const auto unit_m = static_cast<float>(live.info.depth_unit_m);
  Image<float> result(depth.width(), depth.height());
  std::ranges::transform(depth.pixels(), result.pixels().begin(), [&](std::uint16_t units) {
    return units == no_depth ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(units) * unit_m;
  });
  return result;
}

ColorImage in_color(const GrayImage& grey) {
  ColorImage picture(grey.width(), grey.height());
  std::ranges::transform(grey.pixels(), picture.pixels().begin(), [](std::uint8_t level) {
    return Rgb{level, level, level};
  });
  return picture;
}

}  // namespace

bool has_picture(const LiveFrame& live, Stream stream) { return brings(live.frame, stream); }

ColorImage picture_of(const LiveFrame& live, Stream stream) {
  if (!brings(live.frame, stream))
    throw Error("camera", fmt::format("has no {} image at the moment", name_of(stream)), "try again");
  if (stream == Stream::color) return *live.frame.color;
  if (stream == Stream::infrared) return in_color(grey_levels(live.frame.infrared.at(Imager::left)));
  const Image<float> depth_m = metres(live);
  return colorize(depth_m, scale_of_depth(depth_m));
}

LivePictures::LivePictures(const LiveCamera& camera, Listener listener)
    : camera_(camera),
      listener_(std::move(listener)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void LivePictures::watch(Stream stream, int change) { watchers_.at(index_of(stream)) += change; }

// Colour is looked up in the info, since it may be missing in every second frame of a camera that moves.
std::vector<Stream> LivePictures::streams() const {
  const std::shared_ptr<const LiveFrame> live = camera_.newest();
  std::vector<Stream> streams;
  if (!live) return streams;
  if (live->info.color) streams.push_back(Stream::color);
  streams.push_back(Stream::depth);
  if (live->frame.infrared.contains(Imager::left)) streams.push_back(Stream::infrared);
  return streams;
}

void LivePictures::run(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds patience{100};
  std::shared_ptr<const LiveFrame> seen;
  while (!stop.stop_requested()) {
    const std::shared_ptr<const LiveFrame> live = camera_.wait_for_other(seen.get(), patience);
    if (!live) continue;
    seen = live;
    for (const auto& [stream, name] : enum_names<Stream>) {
      if (watchers_.at(index_of(stream)) > 0 && brings(live->frame, stream)) listener_(encode(*live, stream));
    }
  }
}

// The scale is kept for several frames, so that colours do not flicker.
ColorImage LivePictures::colorized(const LiveFrame& live) {
  constexpr std::uint64_t held_frames = 30;
  const Image<float> depth_m = metres(live);
  const std::uint64_t number = live.frame.number;
  if (!scale_m_ || number < scale_number_ || number - scale_number_ >= held_frames) {
    scale_m_ = scale_of_depth(depth_m);
    scale_number_ = number;
  }
  return colorize(depth_m, *scale_m_);
}

std::shared_ptr<const LivePicture> LivePictures::encode(const LiveFrame& live, Stream stream) {
  auto picture = std::make_shared<LivePicture>();
  picture->stream = stream;
  picture->number = live.frame.number;
  picture->taken_at = live.taken_at;
  const auto fill = [&](const auto& image) {
    picture->width = image.width();
    picture->height = image.height();
    picture->jpeg = encode_jpeg(image, quality);
  };
  switch (stream) {
    case Stream::color:
      fill(*live.frame.color);
      break;
    case Stream::depth:
      fill(colorized(live));
      picture->scale_m = scale_m_;
      break;
    case Stream::infrared:
      fill(grey_levels(live.frame.infrared.at(Imager::left)));
      break;
  }
  return picture;
}

}  // namespace rva
