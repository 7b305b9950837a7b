#include "map/view_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

namespace fs = std::filesystem;
using Start = ViewFolder::Start;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ViewFolderTest : public testing::Test {
 protected:
  void put(const fs::path& file) {
    fs::create_directories((views_ / file).parent_path());
    write_file(views_ / file, "{}");
  }
  auto opening(Start start, std::size_t views = 6) {
    return [this, start, views] { const ViewFolder folder(views_, start, views); };
  }
  test::TemporaryFolder folder_;
  fs::path views_ = folder_ / "map.views";
};

TEST_F(ViewFolderTest, IsGoneWhenNothingWasTaken) {
  opening(Start::anew)();
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(ViewFolderTest, KeepsWhatWasTakenForALaterRun) {
  {
    const ViewFolder folder(views_, Start::anew, 6);
    put("000/capture.json");
  }
  EXPECT_THAT(opening(Start::anew), ThrowsMessage<Error>(HasSubstr("resume")));
  opening(Start::resume)();
  EXPECT_TRUE(fs::exists(views_ / "000" / "capture.json"));
}

TEST_F(ViewFolderTest, IsForOneAtATime) {
  const ViewFolder folder(views_, Start::anew, 6);
  EXPECT_THAT(opening(Start::resume), ThrowsMessage<Error>(HasSubstr("being filled")));
  EXPECT_TRUE(fs::exists(views_)) << "it is the first one's";
  put("000/capture.json");
  EXPECT_THAT(opening(Start::resume), ThrowsMessage<Error>(HasSubstr("being filled")));
  EXPECT_THAT(opening(Start::replace), ThrowsMessage<Error>(HasSubstr("being filled")));
  EXPECT_TRUE(fs::exists(views_ / "000" / "capture.json"));
}

TEST_F(ViewFolderTest, EarlierViewsStayWhereTheyAreWhileOthersAreTaken) {
  put("000/capture.json");
  put("001/depth/000000.png");
  {
    const ViewFolder folder(views_, Start::replace, 6);
    EXPECT_EQ(folder.path(), next_views(views_));
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_TRUE(fs::exists(views_ / "001" / "depth" / "000000.png"));
  }
  EXPECT_FALSE(fs::exists(next_views(views_))) << "nothing was taken";
  EXPECT_TRUE(fs::exists(views_ / "001" / "depth" / "000000.png"));
}

TEST_F(ViewFolderTest, ResumesWhatWasToReplaceEarlierViews) {
  put("000/capture.json");
  {
    const ViewFolder interrupted(views_, Start::replace, 6);
    fs::create_directories(interrupted.path() / "000");
    write_file(interrupted.path() / "000" / "capture.json", "new");
  }
  EXPECT_EQ(ViewFolder(views_, Start::resume, 6).path(), next_views(views_));
  EXPECT_EQ(read_text_file(next_views(views_) / "000" / "capture.json"), "new");
  opening(Start::replace)();
  EXPECT_FALSE(fs::exists(next_views(views_))) << "begun anew, and nothing was taken";
  EXPECT_TRUE(fs::exists(views_ / "000" / "capture.json"));
}

TEST_F(ViewFolderTest, WhatAKilledProgramLeftIsNoView) {
  put("000.partial-17-0/capture.json");
  opening(Start::replace)();
  EXPECT_FALSE(fs::exists(views_));
}

TEST_F(ViewFolderTest, ALinkIsLeftAlone) {
  fs::create_directory(folder_ / "other");
  fs::create_directory_symlink(folder_ / "other", views_);
  opening(Start::resume)();
  EXPECT_TRUE(fs::is_symlink(views_));
  write_file(folder_ / "other" / "mine", "");
  EXPECT_THROW(opening(Start::replace)(), Error);
  EXPECT_TRUE(fs::is_symlink(views_));
}

TEST_F(ViewFolderTest, WhatIsNoViewIsNotReplaced) {
  put("000/capture.json");
  put("2023/holiday.jpg");
  EXPECT_THROW(opening(Start::replace)(), Error);
  fs::remove_all(views_ / "2023");
  put("000/thesis.tex");
  EXPECT_THROW(opening(Start::replace)(), Error);
  EXPECT_TRUE(fs::exists(views_ / "000" / "thesis.tex"));
}

TEST_F(ViewFolderTest, WhatAKilledProgramLeftGoes) {
  put("000/capture.json");
  put("001.partial-17-0/depth/000000.png");
  opening(Start::resume)();
  EXPECT_FALSE(fs::exists(views_ / "001.partial-17-0"));
  EXPECT_TRUE(fs::exists(views_ / "000"));
}

TEST_F(ViewFolderTest, MoreViewsThanWaypointsAreRefused) {
  put("000/capture.json");
  put("002/capture.json");
  EXPECT_THAT(opening(Start::resume, 2), ThrowsMessage<Error>(HasSubstr("more than the 2 views")));
  opening(Start::resume, 3)();
  opening(Start::resume, 1000)();
}

}  // namespace
}  // namespace rva
