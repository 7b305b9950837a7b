// What the program knows, as the API says it (docs/api.md).
#pragma once

#include <nlohmann/json.hpp>

#include "inspect/inspection.hpp"
#include "inspect/readiness.hpp"
#include "inspect/task.hpp"
#include "server/server_parts.hpp"

namespace rva {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json json_of(const PanTilt& joints);
/// Without findings: of the list.
[[nodiscard]] Json json_of(const InspectionSummary& summary);
[[nodiscard]] Json json_of(const Inspection& inspection);
[[nodiscard]] Json json_of(const ReviewedFinding& finding);
[[nodiscard]] Json json_of(const Readiness& readiness);
[[nodiscard]] Json json_of(const TaskState& task);
[[nodiscard]] Json json_of(const DriveState& state, const RobotLimits& limits);
[[nodiscard]] Json json_of(const DetectionLevelSummary& levels);

}  // namespace rva
