// A capture whose frames are in memory.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"

namespace rva {

/// A depth frame, with the images and metadata that belong to it.
struct MemoryFrame {
  DepthImage depth;                            ///< in the depth units of the capture
  std::optional<ColorImage> color{};           ///< empty if none was taken with the frame
  std::map<Imager, FineGrayImage> infrared{};  ///< under the projector, by imager
  FrameMetadata metadata{};                    ///< what the camera stated about the frame
};

/// A capture in memory, for a recording that is replayed in a loop: decoding takes longer than showing.
class MemoryCapture : public Capture {
 public:
  /// @param frames at least one, with the image sizes that `info` states
  MemoryCapture(CaptureInfo info, std::vector<MemoryFrame> frames);

  [[nodiscard]] std::size_t depth_frames() const override { return frames_.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return with_color_.size(); }
  [[nodiscard]] DepthImage depth(std::size_t i) const override { return frames_.at(i).depth; }
  [[nodiscard]] ColorImage color(std::size_t i) const override { return *frames_[with_color_.at(i)].color; }
  [[nodiscard]] std::optional<ColorImage> color_of(std::size_t i) const override {
    return frames_.at(i).color;
  }
  [[nodiscard]] std::optional<FineGrayImage> infrared_of(std::size_t i, Imager imager) const override {
    const auto found = frames_.at(i).infrared.find(imager);
    return found == frames_.at(i).infrared.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] bool has_infrared(Imager imager, Light light) const override {
    return light == Light::projector && frames_.front().infrared.contains(imager);
  }
  [[nodiscard]] FrameMetadata metadata_of(std::size_t i) const override { return frames_.at(i).metadata; }

 private:
  std::vector<MemoryFrame> frames_;
  std::vector<std::size_t> with_color_;
};

/// Loads the first frames of a capture, as many as fit into memory.
/// @param most_bytes loading ends at the frame that reaches this size, so that it may be exceeded by
///                   one frame
/// @throws Error when a frame cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Capture> load_to_memory(const Capture& capture, std::size_t most_bytes,
                                                      const Progress& progress);

}  // namespace rva
