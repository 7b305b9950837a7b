// The check-out list of an inspection: tools and parts that are taken into the bay, each of which has to come
// out again or be accounted for before the inspection is closed (NAS 412 calls this tool control).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/enum_names.hpp"

namespace rva {

/// Limits of a check-out list.
inline constexpr std::size_t most_listed_items = 1000;
/// See most_listed_items. Of one line.
inline constexpr int most_item_quantity = 100'000;
/// See most_listed_items. Of a text, in bytes.
inline constexpr std::size_t most_item_bytes = 200;

/// A line of the list, as it is taken in.
struct ListedItem {
  std::string name;      ///< what it is; not empty
  std::string identity;  ///< number or serial number of a tool; may be empty
  int quantity = 1;      ///< 1 to most_item_quantity

  bool operator==(const ListedItem&) const = default;
};

/// What a person states of an item: how many of it came out, stay in as installed work, or are lost. Never
/// changed: a later statement supersedes it.
struct ItemStatement {
  int returned = 0;       ///< came out
  int used = 0;           ///< stay in the structure, as planned, or were consumed
  int lost = 0;           ///< cannot be found
  bool released = false;  ///< a person takes the responsibility for those that are lost
  std::string note;
  std::string person;
  std::string stated_at;  ///< ISO 8601
};

/// What is known of an item.
enum class ItemState {
  out,       ///< some of it are neither returned nor used nor lost
  lost,      ///< the others are accounted for, and nobody has released those that are lost
  released,  ///< the others are accounted for, and a person has released those that are lost
  back,      ///< all of it are returned or used
};
template <>
inline constexpr auto enum_names<ItemState> = std::to_array<EnumName<ItemState>>({
    {ItemState::out, "out"},
    {ItemState::lost, "lost"},
    {ItemState::released, "released"},
    {ItemState::back, "back"},
});

/// An item of an inspection.
struct CheckedOutItem {
  int number = 0;  ///< from 1 within its inspection
  ListedItem item;
  std::string person;                       ///< who took it in
  std::string taken_at;                     ///< ISO 8601
  std::vector<ItemStatement> statements{};  ///< in their order; the last one applies
};

/// By the last statement.
[[nodiscard]] ItemState state_of(const CheckedOutItem& item);

/// How many of an item are in a state.
[[nodiscard]] std::size_t count_in(const std::vector<CheckedOutItem>& items, ItemState state);

/// Reads a check-out list from CSV. The first line names the columns: `item`, and optionally `number` and
/// `quantity`, in any order and case.
/// @param source where it is from, for errors
/// @throws Error when it is not CSV, a column is missing, unknown or there twice, a value is missing, too
/// long
///         or no quantity, or there are no lines or more than most_listed_items
[[nodiscard]] std::vector<ListedItem> parse_checkout_list(std::string_view csv, const std::string& source);

/// @param subject the item, for errors
/// @throws Error when an item may not be stated so: a negative number, more than its quantity, or a release
///         without anything lost or without a note
void require_valid(const ItemStatement& statement, const ListedItem& item, const std::string& subject);

/// @throws Error when a line is not within the limits
void require_valid(const ListedItem& item, const std::string& subject);

}  // namespace rva
