#include "server/request_body.hpp"

#include <gtest/gtest.h>

#include "server/api.hpp"

namespace rva {
namespace {

TEST(RequestBody, OnlyAnObjectWillDo) {
  EXPECT_TRUE(parse_body("").empty());
  EXPECT_EQ(text_field(parse_body(R"({"a":"b"})"), "a"), "b");
  for (const char* const text : {"[]", "1", "null", "{", "{\"a\":}", "\xff\xfe", "{\"a\":1}x", "\"\\ud800\""})
    EXPECT_THROW(static_cast<void>(parse_body(text)), ApiError) << text;
}

TEST(RequestBody, IsNotNestedWithoutEnd) {
  const std::string deep = R"({"a":)" + std::string(100, '[') + std::string(100, ']') + "}";
  EXPECT_THROW(static_cast<void>(parse_body(deep)), ApiError);
}

TEST(RequestBody, TextsAreShortAndPrintable) {
  const Json body = parse_body(R"({"a":"line\nline","b":"bell\u0007","n":1,"null":null})");
  EXPECT_EQ(text_field(body, "a"), "line\nline");
  EXPECT_EQ(text_field(body, "missing"), "");
  EXPECT_EQ(text_field(body, "null"), "");
  EXPECT_THROW(static_cast<void>(text_field(body, "b")), ApiError);
  EXPECT_THROW(static_cast<void>(text_field(body, "n")), ApiError);
  EXPECT_THROW(static_cast<void>(text_field(body, "a", 3)), ApiError);
}

TEST(RequestBody, NumbersAreFinite) {
  const Json body = parse_body(R"({"n":1.5,"t":"1"})");
  EXPECT_EQ(number_field(body, "n"), 1.5);
  EXPECT_THROW(static_cast<void>(number_field(body, "t")), ApiError);
  EXPECT_THROW(static_cast<void>(number_field(body, "missing")), ApiError);
  EXPECT_THROW(static_cast<void>(parse_body(R"({"n":1e999})")), ApiError);
}

}  // namespace
}  // namespace rva
