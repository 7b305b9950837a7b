// Finds a check by its name.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "doctor/checkup.hpp"

namespace rva::test {

inline const CheckedItem& item(const CheckedItems& items, const std::string& name) {
  const auto found = std::ranges::find(items, name, &CheckedItem::name);
  if (found == items.end()) throw std::runtime_error("no check " + name);
  return *found;
}

/// "ok", "failed"; and that a complaint has advice, in one line each.
inline std::string state(const CheckedItems& items, const std::string& name) {
  const CheckedItem& found = item(items, name);
  const bool complains = found.state == CheckState::warning || found.state == CheckState::failed;
  if (complains == found.advice.empty()) throw std::runtime_error(name + ": advice: " + found.advice);
  if (found.result.empty() || (found.result + found.advice).find('\n') != std::string::npos)
    throw std::runtime_error(name + ": not one line: " + found.result);
  return std::string(name_of(found.state));
}

}  // namespace rva::test
