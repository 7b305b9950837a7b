#include "doctor/checkup.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "doctor/version.hpp"

namespace rva {
namespace {

Checkup with(CheckState camera, CheckState robot) {
  return {{passed("disk", "much is free")},
          {{"camera", camera, "seen", "", {}}},
          {{"robot", robot, "seen", "do this", {{"stop_s", 0.1}}}}};
}

TEST(Checkup, IsAsGoodAsItsWorstCheckThatWasTried) {
  EXPECT_EQ(worst(with(CheckState::ok, CheckState::not_tried)), CheckState::ok);
  EXPECT_EQ(worst(with(CheckState::warning, CheckState::not_tried)), CheckState::warning);
  EXPECT_EQ(worst(with(CheckState::warning, CheckState::failed)), CheckState::failed);
}

TEST(Checkup, IsAListInTheOrderOfTheChecks) {
  const nlohmann::ordered_json json = json_of(with(CheckState::ok, CheckState::failed));
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0]["part"], "computer");
  EXPECT_FALSE(json[0].contains("advice"));
  EXPECT_EQ(json[2].dump(),
            R"({"part":"robot","name":"robot","state":"failed","result":"seen","advice":"do this","values":)"
            R"({"stop_s":0.1}})");
}

TEST(Checkup, TakesTheAdviceFromAnError) {
  const CheckedItem item = failed("servos", Error("servo 2", "does not answer", "check its cable"));
  EXPECT_EQ(item.result, "servo 2: does not answer");
  EXPECT_EQ(item.advice, "check its cable");
}

TEST(Version, IsComparedByNumbersAndNotByLetters) {
  EXPECT_LT(version_numbers("5.9.0.50"), version_numbers("5.13.0.50"));
  EXPECT_LT(version_numbers("5.13"), version_numbers("5.13.0.1"));
  EXPECT_EQ(version_numbers("1.1.0"), (std::vector<int>{1, 1, 0}));
  for (const char* const none : {"", ".", "1.", ".1", "1..2", "1.a", "v1", "-1", "99999999999999999999"})
    EXPECT_EQ(version_numbers(none), std::nullopt) << none;
}

}  // namespace
}  // namespace rva
