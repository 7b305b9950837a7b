#include "evaluate/shake_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "evaluate/loose_bay.hpp"

namespace rva {
namespace {

ShakeInspection inspection(bool found, bool stated, std::size_t others) {
  ShakeInspection done;
  done.found = found;
  done.stated = stated;
  done.others = others;
  if (stated) done.direction_off_deg = 20.0;
  return done;
}

TEST(LooseBay, HasOnePartThatMovedByFiveMillimetres) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const LooseBay bay = random_loose_bay(seed);
    EXPECT_EQ(bay.before.objects.size(), bay.after.objects.size());
    EXPECT_EQ(bay.before.objects.back().role, Role::debris);
    EXPECT_EQ(bay.before.objects.back().kind, bay.after.objects.back().kind);
    EXPECT_NEAR((bay.is_m - bay.was_m).norm(), 0.005, 1e-5) << seed;
    EXPECT_LE(bay.was_m.z(), 0.6) << seed;
    EXPECT_EQ(random_loose_bay(seed).is_m, bay.is_m) << "the same for the same seed";
  }
}

TEST(ShakeStudy, TableCountsWhatWasFound) {
  const std::vector<ShakeInspection> inspections{inspection(true, true, 0), inspection(true, false, 1),
                                                 inspection(false, false, 0)};
  EXPECT_THAT(to_table(inspections, Shaken::loose), testing::ContainsRegex("loose .*2/3 .*1/3 .*20, 20"));
  const std::string nothing = to_table({inspection(false, false, 1)}, Shaken::nothing);
  EXPECT_THAT(nothing, testing::ContainsRegex("nothing +- +- +- +1 \\("));
}

TEST(ShakeStudy, JsonHasEachInspection) {
  const nlohmann::ordered_json json =
      json_of({inspection(true, true, 0), inspection(true, false, 0)}, Shaken::loose);
  EXPECT_EQ(json.at("format"), "rva-evaluation-shake");
  EXPECT_EQ(json.at("moved"), "loose");
  EXPECT_EQ(json.at("inspections").at(0).at("direction_off_deg"), 20.0);
  EXPECT_FALSE(json.at("inspections").at(1).contains("direction_off_deg"));
}

TEST(ShakeStudy, RefusesOptionsOutOfRange) {
  StudyOptions options;
  options.inspections = 0;
  EXPECT_THROW((void)run_shake_study(options, Shaken::loose, {}), UsageError);
}

}  // namespace
}  // namespace rva
