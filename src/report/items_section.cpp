#include <fmt/format.h>

#include <string>
#include <vector>

#include "report/report_sections.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

std::string state_text(const CheckedOutItem& item) {
  if (item.statements.empty()) return "in the bay";
  const ItemStatement& last = item.statements.back();
  std::vector<std::string> parts;
  if (last.returned > 0) parts.push_back(fmt::format("{} returned", last.returned));
  if (last.used > 0) parts.push_back(fmt::format("{} used or installed", last.used));
  if (last.lost > 0) parts.push_back(fmt::format("{} lost{}", last.lost, last.released ? ", released" : ""));
  const int out = item.item.quantity - last.returned - last.used - last.lost;
  if (out > 0) parts.push_back(fmt::format("{} in the bay", out));
  return listed(parts);
}

bool is_accounted_for(const CheckedOutItem& item) { return state_of(item) == ItemState::back; }

std::vector<Content> row_of(const CheckedOutItem& item) {
  const Content state = is_accounted_for(item)
                            ? Content::text(state_text(item))
                            : Content::of(PartRole::strong, Content::text(state_text(item)));
  if (item.statements.empty())
    return {Content::typed(item.item.name), Content::typed(item.item.identity),
            Content::text(std::to_string(item.item.quantity)), state, Content()};
  const ItemStatement& last = item.statements.back();
  Content by = Content::typed(last.person) + Content::text(", " + time_text(last.stated_at));
  if (!last.note.empty()) by += Content::text(": ") + Content::typed(last.note);
  return {Content::typed(item.item.name), Content::typed(item.item.identity),
          Content::text(std::to_string(item.item.quantity)), state, by};
}

}  // namespace

Content items_section(const Inspection& inspection) {
  if (inspection.items.empty()) return {};
  ReportTable table{
      .role = PartRole::table,
      .head = {Content::text("Tool or part"), Content::text("Number"), Content::text("Quantity"),
               Content::text("What became of it"), Content::text("Stated by")},
      .rows = {}};
  for (const CheckedOutItem& item : inspection.items) table.rows.push_back(row_of(item));
  return Content::of(PartRole::heading, Content::text("Check-out list")) + content_of(table);
}

}  // namespace rva
