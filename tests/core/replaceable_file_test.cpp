#include "core/replaceable_file.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

TEST(ReplaceableFile, IsReplacedOnRequestAndAFolderNever) {
  const test::TemporaryFolder folder;
  write_file(folder / "map.ply", "points");
  for (const bool overwrite : {false, true}) {
    EXPECT_NO_THROW(require_replaceable(folder / "new.ply", overwrite));
    EXPECT_THROW(require_replaceable(folder.path(), overwrite), ExistsError);
  }
  EXPECT_NO_THROW(require_replaceable(folder / "map.ply", true));
  EXPECT_THROW(require_replaceable(folder / "map.ply", false), ExistsError);
}

}  // namespace
}  // namespace rva
