#include "core/path_text.hpp"
#include "inspect/checkout.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {

namespace {

// Spreadsheets of some systems end lines with two characters, of which one is no text elsewhere.
std::string csv_in(const Json& body) {
  Json list{{"csv", body.value("csv", Json())}};
  if (list["csv"].is_string()) {
    auto text = list["csv"].get<std::string>();
    for (std::size_t at = text.find("\r\n"); at != text.npos; at = text.find("\r\n", at)) text.erase(at, 1);
    list["csv"] = text;
  }
  return text_field(list, "csv", most_list_bytes);
}

}  // namespace

ApiResponse Api::check_out(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.check_out(id, parse_checkout_list(csv_in(call.body), "list"), person_of(call));
  return whole_inspection(id, 201);
}

ApiResponse Api::state_item(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const std::optional<int> item = number_in_path(call.path_parts.at(1));
  if (!item)
    throw ApiError(404, "not-found", "item", printable(call.path_parts.at(1)) + " is not a number",
                   "see the check-out list");
  const ItemStatement statement{.returned = count_field(call.body, "returned"),
                                .used = count_field(call.body, "used"),
                                .lost = count_field(call.body, "lost"),
                                .released = flag_field(call.body, "released"),
                                .note = text_field(call.body, "note", most_note_bytes),
                                .person = person_of(call),
                                .stated_at = {}};
  if (statement.released && call.person->role < PersonRole::inspector)
    throw ApiError(403, "not-allowed", call.person->name, "is not allowed to release what is lost",
                   "ask an inspector");
  parts_.inspector.state_item(id, *item, statement);
  return whole_inspection(id);
}

}  // namespace rva
