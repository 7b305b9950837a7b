#include "core/enum_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rva {

enum class Fruit { apple, sour_cherry };
template <>
inline constexpr auto enum_names<Fruit> = std::to_array<EnumName<Fruit>>({
    {Fruit::sour_cherry, "sour-cherry"},
    {Fruit::apple, "apple"},
});

namespace {

TEST(EnumNames, LeadBackToTheirValues) {
  for (const Fruit fruit : {Fruit::apple, Fruit::sour_cherry})
    EXPECT_EQ(value_of<Fruit>(name_of(fruit)), fruit);
  EXPECT_EQ(name_of(Fruit::sour_cherry), "sour-cherry");
}

TEST(EnumNames, HaveNoValueForAnotherName) {
  for (const std::string_view name : {"", "appl", "apples", "Apple"})
    EXPECT_FALSE(value_of<Fruit>(name)) << name;
}

TEST(EnumNames, AreListedInTheOrderOfTheTable) {
  EXPECT_THAT(names_of<Fruit>(), testing::ElementsAre("sour-cherry", "apple"));
}

}  // namespace
}  // namespace rva
