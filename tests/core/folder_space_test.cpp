#include "core/folder_space.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

TEST(FolderSpace, IsThatOfItsDisk) {
  const test::TemporaryFolder folder;
  const FolderSpace space = space_of(folder.path());
  EXPECT_GT(space.size_bytes, 0U);
  EXPECT_LE(space.free_bytes, space.size_bytes);
  EXPECT_THROW(static_cast<void>(space_of(folder / "missing")), Error);
}

TEST(FolderSpace, IsWritableWithoutATrace) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(require_writable(folder.path()));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(require_writable(folder / "missing"), Error);
  write_file(folder / "file", "no folder");
  EXPECT_THROW(require_writable(folder / "file"), Error);
}

}  // namespace
}  // namespace rva
