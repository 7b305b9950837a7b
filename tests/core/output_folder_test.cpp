#include "core/output_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(OutputFolder, AppearsWholeAtCommit) {
  const test::TemporaryFolder folder;
  OutputFolder out(folder / "deep" / "out", {"marker"}, Existing::refuse);
  write_file(out.path("marker"), "1");
  EXPECT_FALSE(fs::exists(folder / "deep" / "out"));
  out.commit();
  EXPECT_EQ(read_text_file(folder / "deep" / "out" / "marker"), "1");
  EXPECT_EQ(entries(folder / "deep"), 1);
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
  const test::TemporaryFolder folder;
  {
    const OutputFolder out(folder / "out", {"marker"}, Existing::refuse);
    write_file(out.path("marker"), "1");
  }
  EXPECT_EQ(entries(folder.path()), 0);
}

TEST(OutputFolder, TakesAnEmptyFolder) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "out");
  OutputFolder out(folder / "out/", {"marker"}, Existing::refuse);
  write_file(out.path("marker"), "1");
  out.commit();
  EXPECT_TRUE(fs::exists(folder / "out" / "marker"));
}

TEST(OutputFolder, RefusesWhatIsThere) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_file(folder / "out" / "mine", "keep");
  write_file(folder / "file", "keep");
  for (const Existing existing : {Existing::refuse, Existing::replace}) {
    EXPECT_THROW((OutputFolder(folder / "out", {"marker"}, existing)), Error);
    EXPECT_THROW((OutputFolder(folder / "file", {"marker"}, existing)), Error);
  }
  EXPECT_EQ(read_text_file(folder / "out" / "mine"), "keep");
  EXPECT_EQ(entries(folder.path()), 2);
}

TEST(OutputFolder, ReplacesOnlyAnEarlierResult) {
  const test::TemporaryFolder folder;
  for (const char* content : {"first", "second"}) {
    OutputFolder out(folder / "out", {"marker", "first", "second"}, Existing::replace);
    write_file(out.path("marker"), content);
    write_file(out.path(content), "");
    out.commit();
  }
  EXPECT_EQ(read_text_file(folder / "out" / "marker"), "second");
  EXPECT_FALSE(fs::exists(folder / "out" / "first"));
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(OutputFolder, KeepsTheEarlierResultUntilCommit) {
  const test::TemporaryFolder folder;
  {
    OutputFolder out(folder / "out", {"marker"}, Existing::replace);
    write_file(out.path("marker"), "first");
    out.commit();
  }
  { const OutputFolder out(folder / "out", {"marker"}, Existing::replace); }
  EXPECT_EQ(read_text_file(folder / "out" / "marker"), "first");
}

TEST(OutputFolder, KeepsWhatAPersonPutBesideAnEarlierResult) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_file(folder / "out" / "marker", "1");
  write_file(folder / "out" / "notes.txt", "mine");
  EXPECT_THROW((OutputFolder(folder / "out", {"marker"}, Existing::replace)), Error);
  EXPECT_EQ(read_text_file(folder / "out" / "notes.txt"), "mine");
}

class OutputFolderWithFrames : public testing::Test {
 protected:
  OutputFolderWithFrames() {
    fs::create_directories(folder_ / "out" / "depth");
    write_file(folder_ / "out" / "marker", "first");
    write_file(folder_ / "out" / "depth" / "000000.png", "first");
  }

  void replace() {
    OutputFolder out(folder_ / "out", {"marker", "depth/[0-9][0-9]*.png"}, Existing::replace);
    write_file(out.path("marker"), "second");
    out.commit();
  }

  void expect_refused() {
    EXPECT_THROW(replace(), Error);
    EXPECT_EQ(read_text_file(folder_ / "out" / "depth" / "000000.png"), "first");
    EXPECT_EQ(entries(folder_.path()), 1);
  }

  test::TemporaryFolder folder_;
};

TEST_F(OutputFolderWithFrames, AreReplacedWhole) {
  replace();
  EXPECT_EQ(read_text_file(folder_ / "out" / "marker"), "second");
  EXPECT_FALSE(fs::exists(folder_ / "out" / "depth"));
  EXPECT_EQ(entries(folder_.path()), 1);
}

TEST_F(OutputFolderWithFrames, KeepWhatAPersonPutAmongThem) {
  for (const char* name : {"notes.txt", "mine.png", ".00.png", "000000.png.bak", "0", "00/00.png"}) {
    const fs::path file = folder_ / "out" / "depth" / name;
    fs::create_directories(file.parent_path());
    write_file(file, "mine");
    expect_refused();
    EXPECT_EQ(read_text_file(file), "mine");
    fs::remove(file);
    if (file.parent_path().filename() != "depth") fs::remove(file.parent_path());
  }
  replace();
}

TEST_F(OutputFolderWithFrames, KeepAnEmptyFolderOrALinkAmongThem) {
  const fs::path among = folder_ / "out" / "depth" / "more";
  fs::create_directory(among);
  expect_refused();
  fs::remove(among);
  fs::create_directory_symlink(folder_.path(), among);
  expect_refused();
}

TEST_F(OutputFolderWithFrames, KeepAFolderUnderAFilesName) {
  fs::create_directory(folder_ / "out" / "depth" / "000001.png");
  expect_refused();
}

TEST(OutputFolder, RefusesAtCommitWhatCameMeanwhile) {
  for (const Existing existing : {Existing::refuse, Existing::replace}) {
    const test::TemporaryFolder folder;
    {
      OutputFolder out(folder / "out", {"marker"}, existing);
      write_file(out.path("marker"), "1");
      fs::create_directory(folder / "out");
      write_file(folder / "out" / "precious", "mine");
      EXPECT_THROW(out.commit(), Error);
    }
    EXPECT_EQ(read_text_file(folder / "out" / "precious"), "mine");
    EXPECT_EQ(entries(folder.path()), 1);
  }
}

TEST(OutputFolder, RefusesAnUnusableTarget) {
  const test::TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_THROW((OutputFolder(folder / "file" / "out", {"marker"}, Existing::refuse)), Error);
  EXPECT_THROW((OutputFolder(folder / "\xFF", {"marker"}, Existing::refuse)), Error);
  EXPECT_THROW((OutputFolder("/proc/out", {"marker"}, Existing::refuse)), Error);
}

}  // namespace
}  // namespace rva
