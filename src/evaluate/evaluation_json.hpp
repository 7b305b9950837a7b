// `evaluation.json` (docs/calibrated.md): the inspections of a study and their totals.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "evaluate/report.hpp"

namespace rva {

/// A study of static cameras with its conditions, as it is written to a file.
struct Evaluation {
  std::string scene;                             ///< the scene file; empty for random wings
  std::string cameras;                           ///< the camera models, as camera_of_each() takes them
  std::string bay;                               ///< names of bay features; empty for plain bays
  std::vector<SimulatedInspection> inspections;  ///< in the order in which they were run
};

/// The content of `evaluation.json`. It includes tallies, but not the pixels of targets.
[[nodiscard]] nlohmann::ordered_json json_of(const Evaluation& evaluation);

/// Reads the inspections of an evaluation, without the pixels of their targets.
/// @param source name of the file, for errors
/// @throws Error if the text is not an evaluation
[[nodiscard]] Evaluation evaluation_from_json(const std::string& text, const std::string& source);

}  // namespace rva
