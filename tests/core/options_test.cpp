#include "core/options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace rva {
namespace {

struct Sample {
  double gap_mm = 2.0;
  int count = 3;
  static void describe(auto&& self, auto&& visit) {
    visit(self.gap_mm, OptionField{"gap-width", "mm", 0, 10, "a gap"});
    visit(self.count, OptionField{"count", "", 1, 5, "a count"});
  }
};

TEST(Options, DefaultsAreInBounds) { EXPECT_NO_THROW(check_options(Sample{})); }

TEST(Options, BoundsThemselvesAreAllowed) {
  EXPECT_NO_THROW(check_options(Sample{.gap_mm = 0.0, .count = 5}));
  EXPECT_NO_THROW(check_options(Sample{.gap_mm = 10.0, .count = 1}));
}

TEST(Options, NamesTheFieldThatIsOut) {
  for (const double bad : {-0.1, 10.1, std::nan(""), HUGE_VAL}) {
    try {
      check_options(Sample{.gap_mm = bad});
      FAIL() << bad;
    } catch (const OptionError& error) {
      EXPECT_EQ(error.source(), "gap-width");
      EXPECT_THAT(error.remedy(), testing::HasSubstr("0 to 10 mm"));
    }
  }
  EXPECT_THROW(check_options(Sample{.count = 6}), UsageError);
}

TEST(Options, JsonNamesCarryTheUnit) {
  EXPECT_EQ(json_name({"min-blob", "px", 0, 1, ""}), "min_blob_px");
  EXPECT_EQ(json_name({"sigmas", "", 0, 1, ""}), "sigmas");
}

}  // namespace
}  // namespace rva
