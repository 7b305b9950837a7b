// What is known of a capture only after all of it has been read.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"

namespace rva {

/// What is known of a capture after reading every frame.
struct CaptureSummary {
  double fill_rate = 0.0;          ///< share of the pixels of all depth images that have a measurement
  double nearest_m = 0.0;          ///< least and greatest measured depth; 0 if nothing was measured
  double farthest_m = 0.0;         ///< likewise
  std::size_t lost = 0;            ///< frames between those of the capture, by the camera's counter
  std::vector<std::string> notes;  ///< remarks on the files and the depth images for the user
};

/// Reads every depth and colour image, so that a capture for which this succeeds is sound.
/// @throws Error when an image cannot be read; Interrupted
[[nodiscard]] CaptureSummary summarize(const Capture& capture, const Progress& progress);

/// What `rva info --json` prints: the description of a capture and its summary.
[[nodiscard]] nlohmann::ordered_json json_of(const Capture& capture, const CaptureSummary& summary);

}  // namespace rva
