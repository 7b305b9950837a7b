// The words of a report, in English; those that the console has, too, are the same.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/inspection.hpp"
#include "report/object_groups.hpp"

namespace rva {

/// "2026-01-01 00:00 UTC" of a time in ISO 8601; another text as it is.
[[nodiscard]] std::string time_text(const std::string& iso_8601);

/// "76 %", rounded down, so that no share is stated as larger than it is.
[[nodiscard]] std::string percent_text(double share);

/// "1 finding", "2 findings". @param plural of the noun
[[nodiscard]] std::string counted(std::size_t count, std::string_view singular, std::string_view plural);

/// "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& parts);

/// "Debris, removed".
[[nodiscard]] std::string_view verdict_text(Verdict verdict);

/// "2 debris removed, 1 false alarm"; "nothing found" where nothing is counted.
[[nodiscard]] std::string counts_text(const VerdictCounts& counts);

/// "Added", or what it is according to the plan.
[[nodiscard]] std::string change_text(const ReviewedFinding& finding);

/// "34 mm × 12 mm, 0.71 m away, at least 8 mm high": what is known of size, distance and height.
[[nodiscard]] std::string measures_text(const Finding& finding);

/// "may be: fastener (91 %)": what the classifier calls it; empty where it is unknown or was not classified.
[[nodiscard]] std::string class_text(const ReviewedFinding& finding);

/// "objects of 5 mm would have been found in 40 % of it, of 10 mm in 70 %", of one view; of several views,
/// with the least shares, "in at least 40 % of each view". Empty where it is not known.
[[nodiscard]] std::string findable_text(const std::vector<FindableShare>& shares, bool is_one_view);

/// For each size, the share in the view in which least of it would have been found; empty where it is not
/// known.
[[nodiscard]] std::vector<FindableShare> least_findable(const std::vector<ComparedView>& views);

}  // namespace rva
