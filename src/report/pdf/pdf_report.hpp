// The report on an inspection as PDF: the contents of the HTML file on numbered pages.
#pragma once

#include <string>

#include "core/enum_names.hpp"
#include "report/report_document.hpp"

namespace rva {

/// The size of a page.
enum class Paper { a4, letter };
template <>
inline constexpr auto enum_names<Paper> = std::to_array<EnumName<Paper>>({
    {Paper::a4, "a4"},
    {Paper::letter, "letter"},
});

/// A PDF file that needs no other file: its fonts are embedded. It states no time but that of the last action
/// in the records, so with the same fonts and the same libraries, the same report has the same bytes.
/// @throws Error when no font is installed
[[nodiscard]] std::string pdf_report(const ReportDocument& report, Paper paper);

}  // namespace rva
