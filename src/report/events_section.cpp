#include "report/actions.hpp"
#include "report/report_sections.hpp"
#include "report/report_words.hpp"

namespace rva {

std::string last_action_at(const InspectionHistory& history) { return actions_of(history).back().at; }

Content events_section(const InspectionHistory& history) {
  ReportTable table{.role = PartRole::events_table,
                    .head = {Content::text("Time"), Content::text("Person"), Content::text("Action")},
                    .rows = {}};
  for (const Action& action : actions_of(history))
    table.rows.push_back({Content::text(time_text(action.at)),
                          action.person.empty() ? Content::text("RVA") : Content::typed(action.person),
                          action.what});
  return Content::of(PartRole::heading, Content::text("Actions, by the computer's clock")) +
         content_of(table);
}

}  // namespace rva
