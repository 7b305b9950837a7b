// The result of detect() as Python has it.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "captures.hpp"
#include "classify/finding_classes.hpp"
#include "core/output_folder.hpp"
#include "detect/detect.hpp"

namespace rva::python {

/// The class Detection.
struct DetectionResult {
  SidesDetection sides;
  std::shared_ptr<const OpenCapture> final;      ///< in whose view the findings are
  nlohmann::ordered_json json{};                 ///< the content of detections.json
  std::optional<nlohmann::ordered_json> plan{};  ///< the content of plan.json, if there was a plan
  std::optional<FindingClasses> classes{};       ///< if a model named the findings
  std::vector<std::string> warnings{};
};

/// The class Finding, which keeps the result alive.
struct ResultFinding {
  std::shared_ptr<const DetectionResult> result;
  std::size_t index = 0;

  [[nodiscard]] const Finding& finding() const { return result->sides.detection.findings.findings[index]; }
  /// What a model calls it; null where it was shown to none.
  [[nodiscard]] const FindingClass* named() const;
};

/// Writes the files of `rva detect`. @return warnings on pictures that are missing or only approximate
/// @throws Error when a file cannot be written
[[nodiscard]] std::vector<std::string> write(const DetectionResult& result, const OutputFolder& out);

/// A finding in one line: kind, size, height, distance, where it is in the image, what it may be.
[[nodiscard]] std::string text_of(const ResultFinding& finding);

/// All findings in words, a line each, with what was compared and the warnings.
[[nodiscard]] std::string text_of(const std::shared_ptr<const DetectionResult>& result);

}  // namespace rva::python
