#include "core/remains.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <iterator>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

class RemainsTest : public testing::Test {
 protected:
  fs::path put(const std::string& file) {
    fs::create_directories((folder_ / file).parent_path());
    write_file(folder_ / file, "1");
    return folder_ / file;
  }
  test::TemporaryFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(RemainsTest, AnUnfinishedResultIsRemovedByTheNextOne) {
  put("out.partial-17-0/marker");
  put("out.partial-17-0/depth/000001.png.partial-17");
  const OutputFolder out(out_, {"marker", "depth/*.png"}, Existing::refuse);
  EXPECT_FALSE(fs::exists(folder_ / "out.partial-17-0"));
  EXPECT_TRUE(out.remains().empty());
}

TEST_F(RemainsTest, WhatIsNoPartOfSuchAResultStaysAndIsNamed) {
  const fs::path other = put("out.partial-17-0/thesis.tex");
  const OutputFolder out(out_, {"marker"}, Existing::refuse);
  EXPECT_TRUE(fs::exists(other));
  EXPECT_EQ(out.remains(), std::vector{other.parent_path()});
}

TEST_F(RemainsTest, ARecordingOfADeviceStays) {
  const fs::path frame = put("out.partial-17-0/depth/000000.png");
  const OutputFolder out(out_, {"marker", "depth/*.png"}, Existing::refuse, Remains::keep);
  EXPECT_TRUE(fs::exists(frame));
  EXPECT_EQ(out.remains().size(), 1U);
}

TEST_F(RemainsTest, WhatAnotherProgramIsWritingIsLeftAlone) {
  const OutputFolder first(out_, {"marker"}, Existing::refuse);
  write_file(first.path("marker"), "1");
  const OutputFolder second(out_, {"marker"}, Existing::refuse);
  EXPECT_TRUE(fs::exists(first.path("marker")));
}

TEST_F(RemainsTest, ResultsOfOtherNamesAreLeftAlone) {
  const fs::path other = put("out2.partial-17-0/marker");
  const fs::path named = put("out.partial-copy/marker");
  const OutputFolder out(out_, {"marker"}, Existing::refuse);
  EXPECT_TRUE(fs::exists(other));
  EXPECT_TRUE(fs::exists(named));
}

TEST_F(RemainsTest, AnEarlierResultThatHadSteppedAsideComesBack) {
  put("out.partial-17-0-replaced/marker");
  put("out.partial-17-0/marker");
  EXPECT_THROW(OutputFolder(out_, {"marker"}, Existing::refuse), Error) << "it is there again";
  EXPECT_TRUE(fs::exists(out_ / "marker"));
  EXPECT_FALSE(fs::exists(folder_ / "out.partial-17-0-replaced"));
}

TEST_F(RemainsTest, AFileUnderWayOfADeadProgramGoesAndThatOfALiveOneStays) {
  const fs::path left = put("file.partial-999999999");  // beyond the numbers of processes
  const fs::path busy = put(fmt::format("file.partial-{}", ::getppid()));
  replace_file(folder_ / "file", "2");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(busy));
  EXPECT_EQ(read_text_file(folder_ / "file"), "2");
}

TEST_F(RemainsTest, AnExchangedResultLeavesNothingBeside) {
  put("out/marker");
  put("out/old");
  OutputFolder out(out_, {"marker", "old"}, Existing::replace);
  write_file(out.path("marker"), "2");
  out.commit();
  EXPECT_EQ(read_text_file(out_ / "marker"), "2");
  EXPECT_FALSE(fs::exists(out_ / "old"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

}  // namespace
}  // namespace rva
