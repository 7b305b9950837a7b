// Which inspections a request asks for.
#pragma once

#include "inspect/inspection.hpp"
#include "server/query.hpp"

namespace rva {

/// The filter in a query: `text`, `stage`, `from`, `until`, `before` and `most`, all optional (docs/api.md).
/// @throws ApiError (400) for a value that is none, and for any other key
[[nodiscard]] InspectionFilter filter_in(const QueryValues& query);

}  // namespace rva
