// `evaluation.json` (docs/calibrated.md): a study's inspections, and what they come to.
#pragma once

#include <string>
#include <vector>

#include "evaluate/report.hpp"

namespace rva {

struct Evaluation {
  std::string scene;    ///< the file that was inspected; empty for wings drawn by chance
  std::string cameras;  ///< as of --cameras
  std::string bay;      ///< as of --bay; empty for plain ones
  std::vector<SimulatedInspection> inspections;
};

/// Ends in a line feed. Tallies are added; the pixels of targets are left out.
[[nodiscard]] std::string to_json(const Evaluation& evaluation);

/// @param place of the file, for errors
/// @return targets without their pixels
/// @throws Error when the text is not an evaluation
[[nodiscard]] Evaluation evaluation_from_json(const std::string& text, const std::string& place);

}  // namespace rva
