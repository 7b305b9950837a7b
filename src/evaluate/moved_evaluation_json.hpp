// A study of moved cameras in JSON, which a study that goes on is read from.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "evaluate/moved_study.hpp"

namespace rva {

/// The content of `evaluation.json` of a study of moved cameras (docs/spatial.md).
/// @param arguments the arguments of the study, which a resumed run must match
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<MovedInspection>& inspections,
                                             const std::string& arguments);

/// Reads the inspections of a study that is to be resumed, without the pixels of their targets.
/// @throws Error if the text is not such an evaluation; OptionError if the study had other arguments
[[nodiscard]] std::vector<MovedInspection> moved_inspections_from_json(const std::string& text,
                                                                       const std::string& source,
                                                                       const std::string& arguments);

}  // namespace rva
