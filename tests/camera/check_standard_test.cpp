#include "camera/check_standard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"

namespace rva {
namespace {

/// A sound camera whose checks differ as normal quantities do.
class SoundCamera {
 public:
  explicit SoundCamera(unsigned seed) : random_(seed) {}

  CameraCheck check() {
    const auto around = [&](double mean, double share) { return mean * (1.0 + share * normal_(random_)); };
    return {"2026-01-01T00:00:00Z",
            60,
            std::exp(std::log(0.8) + 0.05 * normal_(random_)),
            around(0.9, 0.03),
            around(0.1, 0.1),
            std::exp(std::log(0.7) + 0.03 * normal_(random_)),
            {},
            true};
  }

  std::vector<CameraCheck> checks(std::size_t count) {
    std::vector<CameraCheck> history(count);
    for (CameraCheck& check : history) check = this->check();
    return history;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

TEST(CheckStandard, SaysNothingWithoutAHistory) {
  SoundCamera camera(1);
  CameraCheck bad = camera.check();
  bad.noise_mm = 100.0;
  const CameraJudgement judgement = judge(bad, camera.checks(4));
  EXPECT_FALSE(judgement.known);
  EXPECT_TRUE(judgement.fit);
  EXPECT_EQ(judgement.earlier, 4U);
  EXPECT_FALSE(judgement.quantities[0].high);
}

// The rate at which sound cameras are called unfit does not exceed that of the option, with however few
// checks.
TEST(CheckStandard, CallsNoMoreSoundCamerasUnfitThanAllowed) {
  constexpr int trials = 4000;
  for (const std::size_t earlier : {5U, 20U}) {
    SoundCamera camera(100 + static_cast<unsigned>(earlier));
    int unfit = 0;
    for (int trial = 0; trial < trials; ++trial)
      unfit +=
          judge(camera.check(), camera.checks(earlier), {.false_alarm = 0.05, .least_spread = 0}).fit ? 0 : 1;
    // 200 expected where each of four quantities takes its share; four standard deviations are 55.
    EXPECT_NEAR(unfit, 0.05 * trials, 55) << earlier;
  }
}

TEST(CheckStandard, SaysWhatIsWrong) {
  SoundCamera camera(3);
  const std::vector<CameraCheck> history = camera.checks(10);
  const CameraCheck& sound = history.front();
  const auto unfit = [&](const CameraCheck& check) {
    std::vector<std::string_view> names;
    for (const CheckedQuantity& quantity : judge(check, history).quantities)
      if (!quantity.fit) names.push_back(quantity.name);
    return names;
  };
  CameraCheck check = sound;
  check.noise_mm *= 2;
  EXPECT_THAT(unfit(check), testing::ElementsAre("noise"));
  check = sound;
  check.measured *= 0.5;
  EXPECT_THAT(unfit(check), testing::ElementsAre("measured"));
  check = sound;
  check.drifting = 0.9;
  EXPECT_THAT(unfit(check), testing::ElementsAre("drift"));
  check = sound;
  check.distance_m *= 1.3;
  EXPECT_THAT(unfit(check), testing::ElementsAre("distance"));
  check = sound;
  check.noise_mm *= 0.1;
  check.measured = 1.0;
  check.drifting = 0.0;
  EXPECT_TRUE(judge(check, history).fit) << "better than ever is fit";
}

TEST(CheckStandard, WhatWasUnfitIsNoStandard) {
  SoundCamera camera(4);
  std::vector<CameraCheck> history = camera.checks(8);
  CameraCheck broken = history.front();
  broken.noise_mm *= 3;
  broken.fit = false;
  for (int k = 0; k < 20; ++k) history.push_back(broken);
  const CameraJudgement judgement = judge(broken, history);
  EXPECT_EQ(judgement.earlier, 8U);
  EXPECT_FALSE(judgement.fit);
}

TEST(CheckStandard, ACameraThatRepeatsItselfIsAllowedALittle) {
  SoundCamera camera(5);
  const CameraCheck same = camera.check();
  CameraCheck now = same;
  now.noise_mm *= 1.05;
  EXPECT_TRUE(judge(now, std::vector<CameraCheck>(20, same)).fit);
  now.noise_mm *= 1.2;
  EXPECT_FALSE(judge(now, std::vector<CameraCheck>(20, same)).fit);
}

TEST(CheckStandard, HistoryOutlivesBeingWrittenAndRead) {
  SoundCamera camera(6);
  std::vector<CameraCheck> history = camera.checks(3);
  history[1].temperature_c = 41.5;
  history[2].fit = false;
  std::string text;
  for (const CameraCheck& check : history) text += check_line(check) + "\n";
  const std::vector<CameraCheck> read = parse_checks(text + R"({"taken_at": "half a li)", "history.jsonl");
  ASSERT_EQ(read.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(check_line(read[i]), check_line(history[i]));
}

TEST(CheckStandard, ADamagedHistoryIsRefused) {
  for (const char* line : {"{}\n", "[]\n", "x\n",
                           R"({"taken_at":"now","frames":1,"noise_mm":"2"})"
                           "\n"}) {
    EXPECT_THAT([&] { static_cast<void>(parse_checks(line, "history.jsonl")); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("history.jsonl:1")));
  }
}

TEST(CheckStandard, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(static_cast<void>(judge({}, {}, {.least_checks = 2})), UsageError);
}

}  // namespace
}  // namespace rva
