#include "cli/option_flags.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rva::cli {
namespace {

struct Settings {
  double reach_m = 1.5;
  int frames = 10;
  bool fast = false;

  static void describe(auto&& self, auto&& visit) {
    visit(self.reach_m, OptionField{"reach", "m", 0, 10, "how far"});
    visit(self.frames, OptionField{"frames", "", 1, 100, "how many"});
    visit(self.fast, OptionField{"fast", "", 0, 1, "how fast"});
  }
};

class OptionFlags : public testing::Test {
 protected:
  /// Parses words as those after the program's name. @return whether they were accepted
  bool accepts(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());  // as CLI11 expects them
    try {
      app_.parse(words);
    } catch (const CLI::ParseError&) {
      return false;
    }
    return true;
  }

  CLI::App app_;
};

TEST_F(OptionFlags, NumbersAreWholeTexts) {
  int whole = 0;
  app_.add_option("--n", whole)->check(number_within(-5, 10));
  for (const char* const text :
       {"", " ", "x", "3x", "3.5", "1e1", "0x3", "11", "-6", "nan", "99999999999999999999", "3 "})
    EXPECT_FALSE(accepts({"--n", text})) << text;
  EXPECT_TRUE(accepts({"--n", "-5"}));
  EXPECT_EQ(whole, -5);
  EXPECT_TRUE(accepts({"--n", "+10"}));
  EXPECT_EQ(whole, 10);
}

TEST_F(OptionFlags, NumbersAreFinite) {
  double number = 0.0;
  app_.add_option("--x", number)->check(number_within(0.0, 1e300));
  for (const char* const text : {"nan", "inf", "-nan", "1e999", "-1e-9", "1,5"})
    EXPECT_FALSE(accepts({"--x", text})) << text;
  EXPECT_TRUE(accepts({"--x", "1.5e-3"}));
  EXPECT_EQ(number, 1.5e-3);
}

TEST_F(OptionFlags, CountsAreNotNegativeAndSeedsTakeAllBits) {
  std::size_t frames = 0;
  std::uint64_t seed = 0;
  app_.add_option("--frames", frames)->check(frame_count());
  app_.add_option("--seed", seed)->check(any_seed());
  for (const char* const text : {"-1", "0", "1000001"}) EXPECT_FALSE(accepts({"--frames", text})) << text;
  EXPECT_TRUE(accepts({"--frames", "1000000", "--seed", "18446744073709551615"}));
  EXPECT_EQ(frames, 1'000'000U);
  EXPECT_EQ(seed, 0xFFFFFFFFFFFFFFFFU);
  EXPECT_FALSE(accepts({"--seed", "18446744073709551616"}));
  EXPECT_FALSE(accepts({"--seed", "-1"}));
}

TEST_F(OptionFlags, OfAStructAreItsFields) {
  Settings settings;
  add_flags(app_, settings);
  const std::string help = app_.help();
  for (const char* const text : {"--reach m=1.5", "how far", "--frames NUMBER=10", "--fast NUMBER=0"})
    EXPECT_NE(help.find(text), std::string::npos) << text << " in\n" << help;
  EXPECT_TRUE(accepts({"--reach", "2.25", "--fast", "--frames", "7"}));
  EXPECT_EQ(settings.reach_m, 2.25);
  EXPECT_EQ(settings.frames, 7);
  EXPECT_TRUE(settings.fast) << "without a value it is on";
  EXPECT_TRUE(accepts({"--fast", "false"}));
  EXPECT_FALSE(settings.fast);
  EXPECT_FALSE(accepts({"--reach", "far"}));
  EXPECT_FALSE(accepts({"--frames", "2.5"}));
}

TEST_F(OptionFlags, OfCapturesAreOptionsOfTheReader) {
  CaptureFlags flags;
  flags.add_to(app_);
  EXPECT_FALSE(flags.options().intrinsics);
  EXPECT_FALSE(flags.options().depth_unit_m);
  EXPECT_TRUE(accepts(
      {"--intrinsics", "600,601,320,240", "--depth-unit", "0.25", "--no-depth", "7", "--no-depth", "9"}));
  const CaptureOptions options = flags.options();
  EXPECT_EQ(options.depth_unit_m, 0.00025);
  EXPECT_EQ(options.no_depth, (std::vector<std::uint16_t>{7, 9}));
  ASSERT_TRUE(options.intrinsics);
  EXPECT_EQ(options.intrinsics->fy, 601.0);
  EXPECT_EQ(options.intrinsics->cx, 320.0);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--depth-unit", "0"},
                                                {"--no-depth", "65536"},
                                                {"--no-depth", "-1"},
                                                {"--intrinsics", "1,2,3"}})
    EXPECT_FALSE(accepts(words)) << words[0] << " " << words[1];
}

TEST_F(OptionFlags, OfAnImpossibleCameraAreWrongUsage) {
  CaptureFlags flags;
  for (const std::vector<double>& camera :
       {std::vector<double>{0, 600, 320, 240}, {-1, 600, 320, 240}, {600, NAN, 320, 240}}) {
    flags.intrinsics = camera;
    EXPECT_THROW(static_cast<void>(flags.options()), UsageError) << camera[0];
  }
}

}  // namespace

}  // namespace rva::cli
