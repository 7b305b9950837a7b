// Converts the state of the program to the JSON of the API (docs/api.md).
#pragma once

#include <nlohmann/json.hpp>

#include "inspect/inspection.hpp"
#include "inspect/readiness.hpp"
#include "inspect/task.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// JSON whose keys keep the order in which they were added.
using Json = nlohmann::ordered_json;

[[nodiscard]] Json json_of(const PanTilt& joints);
[[nodiscard]] Json json_of(const TakenSide& side);
[[nodiscard]] Json json_of(const Decision& decision);
/// For the list of inspections, without findings.
[[nodiscard]] Json json_of(const InspectionSummary& summary);
[[nodiscard]] Json json_of(const Inspection& inspection);
[[nodiscard]] Json json_of(const ReviewedFinding& finding);
[[nodiscard]] Json json_of(const ComparedRound& round);
[[nodiscard]] Json json_of(const Readiness& readiness);
[[nodiscard]] Json json_of(const TaskState& task);
[[nodiscard]] Json json_of(const DriveState& state, const RobotLimits& limits);

}  // namespace rva
