// The result of `rva robot repeatability`, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "map/repeatability.hpp"
#include "map/repeatability_summary.hpp"

namespace rva::cli {

/// The summary with every return, as docs/robot.md describes it.
[[nodiscard]] nlohmann::ordered_json json_of(const Repeatability& measured,
                                             const RepeatabilitySummary& summary);

/// Prints the summary for a person, to stdout.
void print_summary(const Repeatability& measured, const RepeatabilitySummary& summary);

}  // namespace rva::cli
