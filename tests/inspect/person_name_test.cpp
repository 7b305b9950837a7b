#include "inspect/person_name.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(PersonName, NamesOfManyLanguagesAreLegible) {
  for (const char* const name : {"Ann", "Ann O'Neil", "J. R. Müller-Lüdenscheidt", "Łukasz", "Нина",
                                 "山田太郎", "محمد", "דוד", "अनिल", "7", "José María", "O’Brien"}) {
    EXPECT_TRUE(is_legible_name(name)) << name;
    EXPECT_TRUE(is_name_of_one_script(name)) << name;
  }
}

TEST(PersonName, WhatCannotBeSeenIsNoName) {
  for (const char* const name : {"",
                                 " ",
                                 "...",
                                 "Ann ",
                                 " Ann",
                                 "Ann  Bee",
                                 "Ann\n",
                                 "Ann\t",
                                 "Ann\x7f",
                                 "Ann\xe2\x80\xae"
                                 "Bee",
                                 "Ann\xe2\x81\xa6",
                                 "\xe2\x80\x8b"
                                 "Ann",
                                 "Ann\xc2\xa0"
                                 "Bee",
                                 "Ann\xc2\xad",
                                 "Ann\xef\xbb\xbf",
                                 "Ann\xe2\x80\xa8",
                                 "\xee\x80\x80"
                                 "A",
                                 "Ann\xff",
                                 "Ann\xc2\x85",
                                 "\xf3\xa0\x80\x81"
                                 "Ann"})
    EXPECT_FALSE(is_legible_name(name)) << name;
}

TEST(PersonName, AnAccountMixesNoScriptsThatLookAlike) {
  EXPECT_FALSE(is_name_of_one_script("\xd0\x90nn")) << "a Cyrillic A";
  EXPECT_FALSE(is_name_of_one_script("Bob \xce\xbf")) << "a Greek o";
  for (const char* const name :
       {"\xef\xbd\x81nn", "a\xcc\xb6nn", "\xe2\x85\xa0van", "ann\xf0\x9f\x98\x80", "a/b", "a_b"})
    EXPECT_FALSE(is_name_of_one_script(name)) << name;
  EXPECT_TRUE(is_legible_name("\xd0\x90nn")) << "what somebody types as their own name is theirs to say";
}

TEST(PersonName, LookAlikesAreFound) {
  EXPECT_TRUE(look_alike("Ann", "Ann"));
  EXPECT_TRUE(look_alike("Ann", "ann"));
  EXPECT_TRUE(look_alike("paul", "\xd1\x80\xd0\xb0ul")) << "Cyrillic letters";
  EXPECT_TRUE(look_alike("rn0", "rnO"));
  EXPECT_TRUE(look_alike("Jos\xc3\xa9", "Jose\xcc\x81")) << "composed in two ways";
  EXPECT_TRUE(look_alike("beIl", "bell")) << "a capital I";
  EXPECT_TRUE(look_alike("AB", "\xce\x91\xce\x92")) << "Greek letters";
  EXPECT_FALSE(look_alike("Ann", "Anna"));
  EXPECT_FALSE(look_alike("M\xc3\xbcller", "Muller"));
}

}  // namespace
}  // namespace rva
