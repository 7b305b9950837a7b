// Writing a capture folder: our own format (docs/captures.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// The description of a capture folder. parse_capture_json() reads every number back to the last bit, except
/// transforms, which it makes orthonormal. Unknown values and empty texts are left out; info.format and
/// info.source_json are not written.
///
/// @param extra_json_object further keys, at any depth, that the format does not define. Keys of the format
///                          are taken from `info` alone, so that an earlier info.source_json may be given as
///                          it is.
/// @throws Error when the extra keys are not a JSON object
[[nodiscard]] nlohmann::ordered_json json_of(const CaptureInfo& info,
                                             const std::string& extra_json_object = "{}");

/// The files that a capture folder may contain, for an OutputFolder.
[[nodiscard]] std::vector<std::string> capture_files();

/// Writes capture.json on construction, without its entries on infrared images, then frames as they arrive,
/// each file whole or not at all: whatever stops the program, the folder can be read with the frames that
/// were written. The caller provides the folder, usually that of an OutputFolder.
///
/// Frames of different numbers may be written on several threads at the same time.
class CaptureWriter {
 public:
  /// @param folder must exist
  /// @throws Error when the description cannot be written, or is impossible (require_possible())
  CaptureWriter(std::filesystem::path folder, const CaptureInfo& info,
                const std::string& extra_json_object = "{}");

  /// @param number of the frame, 0 to 999999. Numbers may be written in any order, but none may be missing in
  ///               the end: frames are read back in the order of their names
  /// @param image  in the unit that the description states; 0 is no measurement
  /// @throws Error when the image is not of the size that the description states, or cannot be written
  void write_depth(std::size_t number, const DepthImage& image) const;

  /// Writes a colour image as write_depth() writes a depth image. Any size is accepted if the description
  /// states no colour intrinsics.
  void write_color(std::size_t number, const ColorImage& image) const;

  /// Writes the mean image of an imager under a light, and its scale and exposure into capture.json. Not for
  /// use by several threads.
  /// @param burst its `per_grey_level` must be that of a FineGrayImage
  /// @throws Error when the image is not of the depth images' size, or cannot be written
  void write_infrared(Imager imager, Light light, const FineGrayImage& mean, const InfraredBurst& burst);

  /// Adds a line to frames.jsonl. Not for use by several threads. A line without a frame is ignored
  /// on reading.
  void write_metadata(std::size_t number, const FrameMetadata& metadata) const;

 private:
  std::filesystem::path folder_;
  CaptureInfo info_;
  std::string extra_json_object_;
};

}  // namespace rva
