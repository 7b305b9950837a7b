// A study of moved cameras as text.
#pragma once

#include <string>
#include <vector>

#include "evaluate/moved_study.hpp"

namespace rva {

/// Tables of findings, of registrations, and of debris found by kind at the usual setting, with intervals of
/// 95 %.
[[nodiscard]] std::string to_table(const std::vector<MovedInspection>& inspections);

}  // namespace rva
