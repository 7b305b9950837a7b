// Recorded results against those that were computed again.
#include "inspect/rerun.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RerunTest : public testing::Test {
 protected:
  RerunTest() {
    for (const char* const side : {"recorded", "again"}) {
      std::filesystem::create_directories(folder_ / side / "results/000");
      write(side, "map.ply", "points");
      write(side, "results/000/detections.json", detections("12.5", "2026-01-01T12:00:00Z", "31"));
    }
  }

  static std::string detections(const std::string& score, const std::string& created_at,
                                const std::string& runtime) {
    return R"({"detections": [{"score": )" + score + R"(}], "runtime_ms": {"total": )" + runtime +
           R"(}, "provenance": {"version": "1", "created_at": ")" + created_at + R"("}})";
  }
  void write(const std::string& side, const std::string& name, const std::string& content) const {
    write_file(folder_ / side / name, content);
  }
  [[nodiscard]] std::vector<std::string> differences() const {
    return differences_between(folder_ / "recorded", folder_ / "again");
  }

  test::TemporaryFolder folder_;
};

TEST_F(RerunTest, TimesAreNoDifference) {
  EXPECT_THAT(differences(), IsEmpty());
  write("again", "results/000/detections.json", detections("12.5", "2026-02-02T12:00:00Z", "47"));
  EXPECT_THAT(differences(), IsEmpty());
}

TEST_F(RerunTest, EveryOtherValueAndByteIs) {
  write("again", "results/000/detections.json",
        detections("12.500000000000002", "2026-02-02T12:00:00Z", "47"));
  write("again", "map.ply", "poinst");
  EXPECT_THAT(
      differences(),
      ElementsAre("map.ply: has other contents",
                  "results/000/detections.json: /detections/0/score is 12.500000000000002, was 12.5"));
}

TEST_F(RerunTest, FilesOfOneSideAreNamed) {
  std::filesystem::remove(folder_ / "again/map.ply");
  write("again", "results/000/plan.json", "{}");
  EXPECT_THAT(differences(),
              ElementsAre("map.ply: was not written again", "results/000/plan.json: is not recorded"));
}

TEST_F(RerunTest, ManyValuesAreCounted) {
  std::string before = "[0";
  std::string after = "[0";
  for (int i = 1; i < 20; ++i) {
    before += "," + std::to_string(i);
    after += "," + std::to_string(-i);
  }
  write("recorded", "results/000/registration.json", before + "]");
  write("again", "results/000/registration.json", after + "]");
  const std::vector<std::string> lines = differences();
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_THAT(lines.back(), HasSubstr("14 more values differ"));
}

TEST_F(RerunTest, AFileThatCannotBeReadIsAnError) {
  write("again", "results/000/detections.json", "{");
  EXPECT_THROW(static_cast<void>(differences()), Error);
  EXPECT_THROW(static_cast<void>(differences_between(folder_ / "none", folder_ / "again")), Error);
}

TEST(RerunFindings, AreComparedWithoutTheirDecisions) {
  ReviewedFinding finding;
  finding.number = 1;
  finding.same_as = 1;
  finding.finding.score = 3.5;
  ReviewedFinding decided = finding;
  decided.decision = Decision{};
  EXPECT_THAT(differences_between({decided}, {finding}), IsEmpty());
  EXPECT_THAT(differences_between({decided}, {}),
              ElementsAre("records: have 1 findings, 0 were found again"));
  finding.finding.score = 3.6;
  EXPECT_THAT(differences_between({decided}, {finding}),
              ElementsAre("records: finding 1 was found differently"));
}

TEST(RerunComparison, NeedsAComparison) {
  const InspectionHistory history;
  EXPECT_THROW(static_cast<void>(latest_comparison(history)), Error);
  EXPECT_THROW(
      static_cast<void>(rerun_comparison(history, InspectionFolder("data", 1), 1, PanTiltChain{}, "out", {})),
      Error);
}

}  // namespace
}  // namespace rva
