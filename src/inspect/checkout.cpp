#include "inspect/checkout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>

#include "core/csv_records.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr const char* format_of_list =
    "give the columns item, number and quantity; number and quantity may be left out";

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string line_of(const std::string& source, const CsvRecord& record) {
  return fmt::format("{}, line {}", source, record.line);
}

/// Which field of a record is which.
class Columns {
 public:
  Columns(const CsvRecord& header, const std::string& source) {
    for (std::size_t k = 0; k < header.fields.size(); ++k) {
      const std::string name = lower_case(trimmed(header.fields[k]));
      if (name != "item" && name != "number" && name != "quantity")
        throw Error(line_of(source, header), "has an unknown column, " + printable(name), format_of_list);
      if (!fields_.emplace(name, k).second)
        throw Error(line_of(source, header), "has the column " + name + " twice", format_of_list);
    }
    if (!fields_.contains("item")) throw Error(line_of(source, header), "has no column item", format_of_list);
  }

  [[nodiscard]] std::size_t count() const { return fields_.size(); }

  /// Empty where the list has no such column.
  [[nodiscard]] std::string field(const CsvRecord& record, const char* name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? "" : trimmed(record.fields.at(found->second));
  }

 private:
  std::map<std::string, std::size_t> fields_;
};

int quantity_in(const std::string& text, const std::string& subject) {
  if (text.empty()) return 1;
  int quantity = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), quantity);
  if (failure != std::errc{} || end != text.data() + text.size())
    throw Error(subject, printable(text) + " is not a quantity", "give a whole number");
  return quantity;
}

}  // namespace

ItemState state_of(const CheckedOutItem& item) {
  if (item.statements.empty()) return ItemState::out;
  const ItemStatement& last = item.statements.back();
  if (last.returned + last.used + last.lost < item.item.quantity) return ItemState::out;
  if (last.lost == 0) return ItemState::back;
  return last.released ? ItemState::released : ItemState::lost;
}

std::size_t count_in(const std::vector<CheckedOutItem>& items, ItemState state) {
  return static_cast<std::size_t>(
      std::ranges::count_if(items, [&](const CheckedOutItem& item) { return state_of(item) == state; }));
}

void require_valid(const ListedItem& item, const std::string& subject) {
  if (item.name.empty()) throw Error(subject, "does not name an item", "name it");
  if (std::max(item.name.size(), item.identity.size()) > most_item_bytes)
    throw Error(subject, fmt::format("has a text of more than {} bytes", most_item_bytes), "shorten it");
  if (item.quantity < 1 || item.quantity > most_item_quantity)
    throw Error(subject, fmt::format("has the quantity {}", item.quantity),
                fmt::format("give 1 to {}", most_item_quantity));
}

void require_valid(const ItemStatement& statement, const ListedItem& item, const std::string& subject) {
  const std::int64_t all = std::int64_t{statement.returned} + statement.used + statement.lost;
  if (statement.returned < 0 || statement.used < 0 || statement.lost < 0 || all > item.quantity)
    throw Error(subject, fmt::format("cannot account for {} of {}", all, item.quantity),
                "state how many were returned, used or lost, together at most the quantity");
  if (statement.released && statement.lost == 0)
    throw Error(subject, "has nothing lost that could be released", "state how many are lost");
  if (statement.released && statement.note.empty())
    throw Error(subject, "cannot be released without a note", "state why the bay may be closed without it");
}

std::vector<ListedItem> parse_checkout_list(std::string_view csv, const std::string& source) {
  const std::vector<CsvRecord> records = parse_csv(csv, source);
  if (records.size() < 2) throw Error(source, "lists no items", format_of_list);
  if (records.size() - 1 > most_listed_items)
    throw Error(source, fmt::format("lists {} items", records.size() - 1),
                fmt::format("give at most {}", most_listed_items));
  const Columns columns(records.front(), source);
  std::vector<ListedItem> items;
  for (auto record = records.begin() + 1; record != records.end(); ++record) {
    const std::string subject = line_of(source, *record);
    if (record->fields.size() != columns.count())
      throw Error(
          subject,
          fmt::format("has {} fields where the first line has {}", record->fields.size(), columns.count()),
          "give each line as many");
    items.push_back({columns.field(*record, "item"), columns.field(*record, "number"),
                     quantity_in(columns.field(*record, "quantity"), subject)});
    require_valid(items.back(), subject);
  }
  return items;
}

}  // namespace rva
