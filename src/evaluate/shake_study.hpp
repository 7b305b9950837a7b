// Evaluation of the shake test: whether a loose part is found that moved between two captures.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/progress.hpp"
#include "evaluate/study.hpp"

namespace rva {

/// What moved while the structure was rocked.
enum class Shaken {
  loose,    ///< one loose part, random_loose_bay()
  nothing,  ///< the same part is there, and did not move
};
/// The names that the command line and evaluation.json use.
template <>
inline constexpr auto enum_names<Shaken> = std::to_array<EnumName<Shaken>>({
    {Shaken::loose, "loose"},
    {Shaken::nothing, "nothing"},
});

/// One simulated shake test.
struct ShakeInspection {
  std::uint64_t seed = 0;    ///< determines everything random
  std::string kind;          ///< of the part, in the catalogue of debris
  double distance_m = 0.0;   ///< of the part
  double moved_mm = 0.0;     ///< in truth
  std::size_t findings = 0;  ///< of the comparison
  std::size_t others = 0;    ///< findings that are not at the part; all of them where nothing moved
  bool found = false;        ///< a finding is at the part, which moved
  bool stated = false;       ///< two findings at it are stated as one loose part
  std::size_t pairs = 0;     ///< loose parts that were stated, at the part or elsewhere
  std::optional<double> direction_off_deg{};  ///< angle between the stated and the true motion in the image
};

/// Runs shake tests one after the other: one capture of 10 frames a side, with infrared images, by a camera
/// that stands still, compared as `rva detect --shake` does.
/// @param options inspections, first seed and sensor; the others have no effect
/// @throws UsageError for options out of range; Error from the captures; Interrupted
[[nodiscard]] std::vector<ShakeInspection> run_shake_study(const StudyOptions& options, Shaken shaken,
                                                           const Progress& progress);

/// A table with intervals of 95 %.
[[nodiscard]] std::string to_table(const std::vector<ShakeInspection>& inspections, Shaken shaken);

/// The content of `evaluation.json`.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<ShakeInspection>& inspections, Shaken shaken);

}  // namespace rva
