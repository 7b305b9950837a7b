#include "camera/realsense/plugged_in.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

class PluggedInTest : public testing::Test {
 protected:
  void plug_in(const char* port, const char* vendor, const char* product, const char* speed) {
    const fs::path folder = folder_ / port;
    fs::create_directory(folder);
    write_file(folder / "idVendor", std::string_view(vendor));
    write_file(folder / "product", std::string_view(product));
    write_file(folder / "speed", std::string_view(speed));
  }

  test::TemporaryFolder folder_;
};

TEST_F(PluggedInTest, FindsRealSensesAndNothingElse) {
  plug_in("1-1", "8086\n", "Intel(R) RealSense(TM) Depth Camera 435\n", "480\n");
  plug_in("1-2", "8086\n", "Some other thing of Intel's\n", "5000\n");
  plug_in("1-3", "046d\n", "RealSense lookalike\n", "480\n");
  fs::create_directory(folder_ / "usb1");
  const std::vector<PluggedIn> found = plugged_in_realsense(folder_.path());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].product, "Intel(R) RealSense(TM) Depth Camera 435");
  EXPECT_EQ(found[0].speed_mbps, 480.0);
}

TEST_F(PluggedInTest, NothingIsThereWhereLinuxListsNothing) {
  EXPECT_TRUE(plugged_in_realsense(folder_ / "none").empty());
}

}  // namespace
}  // namespace rva
