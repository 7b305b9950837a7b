// When an inspection may be closed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/error.hpp"
#include "inspect/inspection.hpp"

namespace rva {

/// Why a statement in words is needed to close an inspection.
enum class ClosingReason {
  debris,    ///< it was removed after the last captures, or cannot be reached: they do not show a bay free of
             ///< it
  coverage,  ///< less than least_inspected of a view was inspected
  lost_item,  ///< an item of the check-out list is lost, and a person has released it
};
template <>
inline constexpr auto enum_names<ClosingReason> = std::to_array<EnumName<ClosingReason>>({
    {ClosingReason::debris, "debris"},
    {ClosingReason::coverage, "coverage"},
    {ClosingReason::lost_item, "lost-item"},
});

/// With a smaller share of a view inspected (ComparedView::judged), that nothing was found there means
/// little.
inline constexpr double least_inspected = 0.5;

/// The reasons for which closing an inspection as it is now needs a note; empty where it needs none.
[[nodiscard]] std::vector<ClosingReason> reasons_for_note(const Inspection& inspection);

/// @throws Error when a person may not close the inspection by this statement: it is closed already; its
///         latest captures are not complete, or not compared; the person reviewed another comparison;
///         something is undecided; an item of the check-out list is not accounted for, or lost and not
///         released; a note is needed and empty
void require_closable(const Inspection& inspection, const Closing& closing);

/// @throws Error when the inspection has been closed
void require_open(const Inspection& inspection);

/// The refusal to change a closed inspection. @param person who closed it
[[nodiscard]] Error closed_inspection(std::int64_t id, const std::string& person);

}  // namespace rva
