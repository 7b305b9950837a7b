// Writing a capture folder: our own format (docs/captures.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "depth/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// The description of a capture folder. parse_capture_json() reads the same back: every number to the last
/// bit, but transforms as it makes them orthonormal. What `info` does not know is left out, and so are empty
/// texts; info.format and info.source_json are not written. Bytes that are not UTF-8 become U+FFFD.
///
/// @param extra_json_object keys that the format does not define, at any depth, to be kept beside those that
///                          it does. Keys of the format come from `info` alone, so that an earlier
///                          info.source_json may be given as it is.
/// @throws Error when the extra keys are not a JSON object
[[nodiscard]] std::string capture_json(const CaptureInfo& info, const std::string& extra_json_object = "{}");

/// What a capture folder may hold, for an OutputFolder.
[[nodiscard]] std::vector<std::string> capture_files();

/// Writes capture.json at once, without what it says of infrared images, then frames as they come, each file
/// whole or not at all: whatever stops the program, the folder can be read with the frames that were written.
/// The folder is the caller's, as a rule the place where an OutputFolder is written.
///
/// Frames of different numbers may be written on several threads at the same time.
class CaptureWriter {
 public:
  /// @param folder exists
  /// @throws Error when the description cannot be written, or is one that no capture can have
  CaptureWriter(std::filesystem::path folder, const CaptureInfo& info,
                const std::string& extra_json_object = "{}");

  /// @param number of the frame, from 0 to 999999, without gaps in the end: frames are read back in the order
  ///               of their names
  /// @param image  in the unit that the description states; 0 is no measurement
  /// @throws Error when the image is not of the size that the description states, or cannot be written
  void write_depth(std::size_t number, const DepthImage& image) const;

  /// As write_depth(); any size where the description states none.
  void write_color(std::size_t number, const ColorImage& image) const;

  /// Writes the only image of an imager in a light, the mean of a burst, and how it counts into capture.json;
  /// for one thread at a time.
  /// @param burst its `per_grey_level` is that of a FineGrayImage
  /// @throws Error when the image is not of the depth images' size, or cannot be written
  void write_infrared(Imager imager, Light light, const FineGrayImage& mean, const InfraredBurst& burst);

  /// Adds a line to frames.jsonl, for one thread at a time. A line without its frame does no harm.
  void write_metadata(std::size_t number, const FrameMetadata& metadata) const;

 private:
  std::filesystem::path folder_;
  CaptureInfo info_;
  std::string extra_json_object_;
};

}  // namespace rva
