// When an inspection may be closed.
#pragma once

#include <cstdint>
#include <string>

#include "core/error.hpp"
#include "inspect/inspection.hpp"

namespace rva {

/// Whether a statement in words is needed to close an inspection, since it ends without pictures of a bay
/// that is free of debris: debris was removed after the last captures, or cannot be reached.
[[nodiscard]] bool closing_needs_note(const Inspection& inspection);

/// @throws Error when a person may not close the inspection by this statement: it is closed already; its
///         latest captures are not complete, or not compared; the person reviewed another comparison;
///         something is undecided; a note is needed and empty
void require_closable(const Inspection& inspection, const Closing& closing);

/// @throws Error when the inspection has been closed
void require_open(const Inspection& inspection);

/// The refusal to change a closed inspection. @param person who closed it
[[nodiscard]] Error closed_inspection(std::int64_t id, const std::string& person);

}  // namespace rva
