// Where a result comes from: its captures, the program and the time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "capture/capture.hpp"

namespace rva {

/// A capture that was compared, as a result names it.
struct CaptureSource {
  std::string path;  ///< as it was given
  std::string format;
  std::size_t frames = 0;   ///< that it has; `frames` in the result states how many were used
  std::string serial;       ///< of its camera; empty where unknown
  std::string captured_at;  ///< ISO 8601; empty where unknown
};

/// What a result states about its making, besides method and parameters.
struct Provenance {
  std::string created_at;  ///< time_of_making()
  std::vector<CaptureSource> initial;
  std::vector<CaptureSource> final;
};

/// Describes the captures of a side. @param paths as they were given, one for each capture
[[nodiscard]] std::vector<CaptureSource> sources_of(const std::vector<std::filesystem::path>& paths,
                                                    const Captures& captures);

/// `provenance` in `detections.json` (docs/detection.md).
[[nodiscard]] nlohmann::ordered_json json_of(const Provenance& provenance);

}  // namespace rva
