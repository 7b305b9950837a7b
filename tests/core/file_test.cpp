#include "core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>

#include "core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

TEST(File, GivesBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  for (const std::string& text : {std::string(), std::string("one\0two", 7), std::string(3U << 20U, 'x')}) {
    write_file(folder / "file", text);
    EXPECT_EQ(read_text_file(folder / "file"), text);
    EXPECT_EQ(read_file(folder / "file").size(), text.size());
  }
}

TEST(File, SaysWhatIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(read_file(folder / "none")), Error);
  EXPECT_THROW(static_cast<void>(read_file(folder.path())), Error);
  EXPECT_THROW(write_file(folder / "none" / "file", "text"), Error);
}

TEST(File, IsReplacedWholeOrStaysAsItWas) {
  const test::TemporaryFolder folder;
  replace_file(folder / "file", "first");
  replace_file(folder / "file", "second");
  EXPECT_EQ(read_text_file(folder / "file"), "second");
  std::filesystem::create_directories(folder / "other" / "x");
  EXPECT_THROW(replace_file(folder / "other", "third"), Error);
  EXPECT_THROW(replace_file(folder / "none" / "file", "third"), Error);
  const std::filesystem::directory_iterator left(folder.path());
  EXPECT_EQ(std::distance(begin(left), end(left)), 2) << "something is left beside";
}

TEST(File, ReportsAFullDisk) {
  // /dev/full is Linux's own: every write to it fails as on a full disk.
  try {
    write_file("/dev/full", "text");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("free some space"));
  }
}

}  // namespace
}  // namespace rva
