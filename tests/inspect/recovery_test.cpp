#include "inspect/recovery.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file.hpp"
#include "inspect/inspection_folder.hpp"
#include "store/sqlite_records.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Recovery : public testing::Test {
 protected:
  Recovery() { id_ = records_.add_inspection({"", "", "", "Ann"}, "t", 1, {{0, 0}}, 0); }
  fs::path put(const fs::path& file) {
    fs::create_directories((inspection_ / file).parent_path());
    write_file(inspection_ / file, file.native());
    return inspection_ / file;
  }
  std::vector<std::string> recover() { return recover_data(folder_.path(), records_); }

  test::TemporaryFolder folder_;
  SqliteRecords records_{folder_ / "rva.db"};
  fs::path inspection_ = InspectionFolder(folder_.path(), 1).path();
  std::int64_t id_ = 0;
};

TEST_F(Recovery, OfAFolderThatIsWholeChangesNothing) {
  records_.set_comparison(id_, {1, "t", "comparison-1"}, {}, {});
  for (const char* const file :
       {"initial/000/capture.json", "final/000/capture.json", "final-2/000/capture.json",
        "comparison-1/map.ply", "notes.txt", "comparison-x/map.ply"})
    put(file);
  EXPECT_THAT(recover(), IsEmpty());
  EXPECT_TRUE(fs::exists(inspection_ / "comparison-1" / "map.ply"));
  EXPECT_TRUE(fs::exists(inspection_ / "comparison-x" / "map.ply"));
}

TEST_F(Recovery, RemovesWhatWasNotCompleteAndSaysSo) {
  put("final-2/000.partial-17-0/depth/000000.png");
  put("comparison-1.partial-17-0/results/000/changes.png");
  put("results/000.partial-17-0-replaced/changes.png");
  put("map.ply.partial");
  const fs::path whole = put("final-2/001/capture.json");
  EXPECT_EQ(recover().size(), 4U);
  EXPECT_TRUE(fs::exists(whole));
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(inspection_))
    EXPECT_THAT(entry.path().native(), testing::Not(HasSubstr(".partial")));
  EXPECT_THAT(recover(), IsEmpty());
}

TEST_F(Recovery, LeavesWhatSomebodyPutThere) {
  for (const char* const file :
       {"notes.partial-2024/mine.txt", "final/000.partial-17-0/mine.txt",
        "comparison-1.partial-17-0/mine.txt", "final/notes.partial-17-0/depth/000000.png"}) {
    const fs::path mine = put(file);
    recover();
    EXPECT_TRUE(fs::exists(mine)) << file;
  }
}

TEST_F(Recovery, RemovesAComparisonThatWasBegunAndNotRecorded) {
  records_.begin_comparison(id_, {1, "", "comparison-1"});
  put("comparison-1/map.ply");
  EXPECT_THAT(recover(), ElementsAre(HasSubstr("not complete")));
  EXPECT_FALSE(fs::exists(inspection_ / "comparison-1"));
}

// The records were restored from a copy that is older than the folder.
TEST_F(Recovery, NamesAComparisonThatTheRecordsDoNotHaveAndLeavesIt) {
  const fs::path shown = put("comparison-2/map.ply");
  EXPECT_THAT(recover(), ElementsAre(HasSubstr("it is kept")));
  EXPECT_TRUE(fs::exists(shown));
}

// As a former version left it when it was killed before the first view of a final side that was taken anew.
TEST_F(Recovery, RemovesUnfinishedPicturesAndNamesThoseWithoutARecord) {
  put("marks/001.png");
  put("marks/002.png");
  put("marks/003.png.partial-17-0");
  static_cast<void>(records_.add_mark(id_, {.picture = "marks/001.png"}));
  EXPECT_THAT(recover(),
              ElementsAre(HasSubstr("003.png.partial-17-0: removed"), HasSubstr("002.png: shows no")));
  EXPECT_TRUE(fs::exists(inspection_ / "marks" / "001.png") && fs::exists(inspection_ / "marks" / "002.png"));
  EXPECT_FALSE(fs::exists(inspection_ / "marks" / "003.png.partial-17-0"));
}

TEST_F(Recovery, RestoresASideThatHadBeenMovedAside) {
  put("final.replaced/000/capture.json");
  put("final/000.partial-17-0/capture.json");
  put("final/001/capture.json");
  EXPECT_FALSE(recover().empty());
  EXPECT_EQ(read_text_file(inspection_ / "final" / "000" / "capture.json"),
            "final.replaced/000/capture.json");
  EXPECT_EQ(read_text_file(inspection_ / "final-2" / "001" / "capture.json"), "final/001/capture.json");
  EXPECT_FALSE(fs::exists(inspection_ / "final-2" / "000.partial-17-0"));
  EXPECT_FALSE(fs::exists(inspection_ / "final.replaced"));
}

TEST_F(Recovery, RestoresASideThatIsMissingAndNotByAnEmptyFolder) {
  put("final.replaced/000/capture.json");
  EXPECT_THAT(recover(), ElementsAre(HasSubstr("restored")));
  EXPECT_TRUE(fs::exists(inspection_ / "final" / "000" / "capture.json"));
  fs::create_directories(inspection_ / "final.replaced");
  EXPECT_THAT(recover(), IsEmpty());
  EXPECT_TRUE(fs::exists(inspection_ / "final" / "000" / "capture.json"));
}

TEST_F(Recovery, FollowsNoLinks) {
  fs::create_directories(folder_ / "elsewhere" / "000.partial-17-0");
  fs::create_directories(inspection_);
  fs::create_directory_symlink(folder_ / "elsewhere", inspection_ / "final");
  recover();
  EXPECT_TRUE(fs::exists(folder_ / "elsewhere" / "000.partial-17-0"));
}

TEST_F(Recovery, NamesAnInspectionThatTheRecordsDoNotHaveAndLeavesIt) {
  fs::create_directories(folder_ / "inspections" / "000007" / "comparison-1");
  EXPECT_THAT(recover(), ElementsAre(HasSubstr("000007")));
  EXPECT_TRUE(fs::exists(folder_ / "inspections" / "000007" / "comparison-1"));
  EXPECT_EQ(InspectionFolder::greatest_id(folder_.path()), 7);
}

}  // namespace
}  // namespace rva
