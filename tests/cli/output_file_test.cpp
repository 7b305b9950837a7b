#include "cli/output_file.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva::cli {
namespace {

TEST(OutputFile, ReplacesAFileOnRequestAndAFolderNever) {
  const test::TemporaryFolder folder;
  write_file(folder / "map.ply", "points");
  for (const bool overwrite : {false, true}) {
    EXPECT_NO_THROW(require_replaceable(folder / "new.ply", overwrite));
    EXPECT_THROW(require_replaceable(folder.path(), overwrite), Error);
  }
  EXPECT_NO_THROW(require_replaceable(folder / "map.ply", true));
  try {
    require_replaceable(folder / "map.ply", false);
    ADD_FAILURE() << "there is a file";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("--overwrite"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rva::cli
