#include "inspect/checkout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <typename Call>
std::string problem(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

std::string problem_of(std::string_view csv) {
  return problem([&] { static_cast<void>(parse_checkout_list(csv, "list")); });
}

ItemStatement stated(int returned, int used, int lost, bool released = false, const char* note = "") {
  return {.returned = returned,
          .used = used,
          .lost = lost,
          .released = released,
          .note = note,
          .person = "Ann",
          .stated_at = "t"};
}

TEST(CheckoutList, IsReadWithItsColumnsInAnyOrder) {
  EXPECT_THAT(parse_checkout_list("item,number,quantity\nwrench,T-12,1\n", "list"),
              ElementsAre(ListedItem{"wrench", "T-12", 1}));
  EXPECT_THAT(parse_checkout_list("Quantity;ITEM\n24; collar \n;rag\n", "list"),
              ElementsAre(ListedItem{"collar", "", 24}, ListedItem{"rag", "", 1}));
}

TEST(CheckoutList, IsRefusedWhereItCouldBeMisread) {
  EXPECT_THAT(problem_of(""), HasSubstr("lists no items"));
  EXPECT_THAT(problem_of("item\n"), HasSubstr("lists no items"));
  EXPECT_THAT(problem_of("number,quantity\nT,1\n"), HasSubstr("no column item"));
  EXPECT_THAT(problem_of("item,price\nwrench,7\n"), HasSubstr("unknown column, price"));
  EXPECT_THAT(problem_of("item,Item\nwrench,x\n"), HasSubstr("the column item twice"));
  EXPECT_THAT(problem_of("item,quantity\nwrench\n"), HasSubstr("line 2: has 1 fields"));
  EXPECT_THAT(problem_of("item,quantity\nwrench,many\n"), HasSubstr("many is not a quantity"));
  EXPECT_THAT(problem_of("item,quantity\nwrench,1.5\n"), HasSubstr("1.5 is not a quantity"));
  EXPECT_THAT(problem_of("item,quantity\nwrench,0\n"), HasSubstr("quantity 0"));
  EXPECT_THAT(problem_of("item,quantity\nwrench,-3\n"), HasSubstr("quantity -3"));
  EXPECT_THAT(problem_of("item,number\n ,T-12\n"), HasSubstr("does not name an item"));
  EXPECT_THAT(problem_of("item\n" + std::string(201, 'x') + "\n"), HasSubstr("more than 200 bytes"));
  std::string many = "item\n";
  for (std::size_t k = 0; k <= most_listed_items; ++k) many += "rivet\n";
  EXPECT_THAT(problem_of(many), HasSubstr("1001 items"));
}

TEST(CheckedOutItem, IsInTheStateOfItsLastStatement) {
  CheckedOutItem item{
      .number = 1, .item = {"collar", "", 24}, .person = "Ann", .taken_at = "t", .statements = {}};
  EXPECT_EQ(state_of(item), ItemState::out);
  const std::vector<std::pair<ItemStatement, ItemState>> statements{
      {stated(20, 3, 0), ItemState::out},
      {stated(20, 3, 1), ItemState::lost},
      {stated(20, 3, 1, true, "drilled out"), ItemState::released},
      {stated(20, 2, 1, true, "x"), ItemState::out},
      {stated(21, 3, 0), ItemState::back},
      {stated(0, 24, 0), ItemState::back},
      {stated(0, 0, 24), ItemState::lost},
      {stated(0, 0, 0), ItemState::out}};
  for (const auto& [statement, state] : statements) {
    item.statements.push_back(statement);
    EXPECT_EQ(state_of(item), state);
  }
  EXPECT_EQ(count_in({item, item}, ItemState::out), 2U);
  EXPECT_EQ(count_in({item}, ItemState::back), 0U);
}

TEST(ItemStatement, AccountsForWhatThereIs) {
  const ListedItem item{"collar", "", 24};
  const auto refused = [&](const ItemStatement& statement) {
    return problem([&] { require_valid(statement, item, "item 1"); });
  };
  EXPECT_EQ(refused(stated(24, 0, 0)), "nothing");
  EXPECT_EQ(refused(stated(0, 0, 1, true, "seen leaving the bay")), "nothing");
  EXPECT_THAT(refused(stated(24, 1, 0)), HasSubstr("25 of 24"));
  EXPECT_THAT(refused(stated(-1, 1, 0)), HasSubstr("cannot account"));
  EXPECT_THAT(refused(stated(1'000'000'000, 1'000'000'000, 1'000'000'000)), HasSubstr("3000000000 of 24"));
  EXPECT_THAT(refused(stated(24, 0, 0, true, "x")), HasSubstr("nothing lost"));
  EXPECT_THAT(refused(stated(23, 0, 1, true)), HasSubstr("without a note"));
}

}  // namespace
}  // namespace rva
