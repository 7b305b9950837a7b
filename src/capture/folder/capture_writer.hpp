// Writing a capture folder: our own format (docs/captures.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "capture/capture_sink.hpp"
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
class CaptureWriter : public CaptureSink {
 public:
  /// @param folder must exist
  /// @throws Error when the description cannot be written, or is impossible (require_possible())
  CaptureWriter(std::filesystem::path folder, const CaptureInfo& info,
                const std::string& extra_json_object = "{}");

  void write_depth(std::size_t number, const DepthImage& image) override;
  void write_color(std::size_t number, const ColorImage& image) override;
  void write_infrared(Imager imager, Light light, const FineGrayImage& mean,
                      const InfraredBurst& burst) override;
  /// Adds a line to frames.jsonl. A line without a frame is ignored on reading.
  void write_metadata(std::size_t number, const FrameMetadata& metadata) override;

 private:
  std::filesystem::path folder_;
  CaptureInfo info_;
  std::string extra_json_object_;
};

}  // namespace rva
