#include "core/json_object.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace rva {
namespace {

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ParseJson, NamesTheLine) {
  EXPECT_THAT(message_of([] { static_cast<void>(parse_json("{\n\"a\": 1,\n}", "file")); }),
              testing::HasSubstr("file: not JSON at line 3"));
  EXPECT_THROW(static_cast<void>(parse_json("", "file")), Error);
  EXPECT_THROW(static_cast<void>(parse_json("\"\xFF\"", "file")), Error);
}

TEST(JsonObject, ReadsWhatIsThere) {
  const auto json =
      parse_json(R"({"n": 2, "s": "text", "o": {"x": 1.5}, "l": [1, 2], "nothing": null})", "file");
  const JsonObject object(json, "file");
  EXPECT_EQ(object.integer("n"), 2);
  EXPECT_EQ(object.string("s"), "text");
  EXPECT_EQ(object.object("o").number("x"), 1.5);
  EXPECT_EQ(object.numbers("l", 2), (std::vector<double>{1, 2}));
  EXPECT_FALSE(object.optional_number("nothing"));
  EXPECT_FALSE(object.optional_object("absent"));
}

TEST(JsonObject, NamesTheFieldThatIsWrong) {
  const auto json =
      parse_json(R"({"n": 2.5, "big": 1e300, "s": "text", "o": {"x": []}, "l": [1, "2"]})", "file");
  const JsonObject object(json, "file");
  EXPECT_THAT(message_of([&] { static_cast<void>(object.integer("n")); }),
              testing::StartsWith("file: n: not a whole"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.integer("big")); }),
              testing::StartsWith("file: big"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.number("s")); }),
              testing::StartsWith("file: s: not a number"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.object("o").number("x")); }),
              testing::StartsWith("file: o.x"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.numbers("l", 2)); }),
              testing::StartsWith("file: l: not a list"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.string("absent")); }),
              testing::StartsWith("file: absent: missing"));
  EXPECT_THAT(message_of([&] { static_cast<void>(object.object("s")); }),
              testing::StartsWith("file: s: not an object"));
}

TEST(JsonText, IsUtf8WhateverTheStringsAre) {
  EXPECT_EQ(json_text(nlohmann::json{{"b", 1}, {"a", "\xFF"}}), "{\"a\":\"\xEF\xBF\xBD\",\"b\":1}");
  EXPECT_EQ(json_text(nlohmann::ordered_json{{"b", 1}, {"a", 2}}), R"({"b":1,"a":2})") << "keeps the order";
}

TEST(JsonText, OfAFileIsIndentedAndEndsInALineFeed) {
  EXPECT_EQ(json_file_text({{"a", 1}}), "{\n \"a\": 1\n}\n");
  EXPECT_EQ(json_file_text({{"a", 1}}, 2), "{\n  \"a\": 1\n}\n");
}

}  // namespace
}  // namespace rva
