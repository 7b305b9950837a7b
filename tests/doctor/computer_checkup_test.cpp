// On a made-up tree of sysfs, nodes and rules.
#include "doctor/computer_checkup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/file.hpp"
#include "tests/doctor/items.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using test::item;
using test::state;
using testing::HasSubstr;

class ComputerCheckup : public testing::Test {
 protected:
  ComputerCheckup() {
    for (const char* const folder : {"sys/bus/usb/devices", "dev/bus/usb/002", "rules", "data"})
      fs::create_directories(folder_ / folder);
    write("rules/60-rva-server.rules", "");
    plug_in("5000");
    write("dev/ttyACM0", "");
    folders_.sys = folder_ / "sys";
    folders_.dev = folder_ / "dev";
    folders_.udev_rules = {folder_ / "missing", folder_ / "rules"};
    // The same for every user that runs the test: only nodes that everybody may open.
    folders_.may_open = [](const fs::path& node) {
      struct stat state {};
      return stat(node.c_str(), &state) == 0 && (state.st_mode & S_IWOTH) != 0;
    };
  }

  void write(const std::string& path, const std::string& text) {
    write_file(folder_ / path, std::string_view(text));
    fs::permissions(folder_ / path, fs::perms::all);
  }
  void plug_in(const std::string& speed) {
    const std::string device = "sys/bus/usb/devices/2-1/";
    fs::create_directories(folder_ / device / "2-1:1.0/video4linux/video0");
    fs::create_directories(folder_ / device / "2-1:1.3/video4linux/video2");
    write(device + "idVendor", "8086\n");
    write(device + "product", "Intel(R) RealSense(TM) Depth Camera 435\n");
    write(device + "speed", speed + "\n");
    write(device + "busnum", "2\n");
    write(device + "devnum", "7\n");
    for (const char* const node : {"dev/bus/usb/002/007", "dev/video0", "dev/video2"}) write(node, "");
  }
  // Restricts a device node to its owner or, with `to_group`, to a group to which this program does not
  // belong.
  void restrict(const std::string& path, bool to_group = true) {
    fs::permissions(folder_ / path, static_cast<fs::perms>(to_group ? 0660 : 0600));
    if (getuid() == 0 && to_group) {
      ASSERT_EQ(chown((folder_ / path).c_str(), 0, 20), 0);
    }
  }
  CheckedItems examine(double least_free_gb = 0.0) {
    return examine_computer({true, folder_ / "dev/ttyACM0", folder_ / "data", least_free_gb}, folders_);
  }

  test::TemporaryFolder folder_;
  ComputerFolders folders_;
};

TEST_F(ComputerCheckup, FindsNothingWrongWhereNothingIs) {
  const CheckedItems items = examine();
  for (const CheckedItem& one : items) EXPECT_EQ(state(items, one.name), "ok") << one.name << one.result;
  EXPECT_THAT(item(items, "camera-rights").result, HasSubstr("3 nodes"));
  EXPECT_EQ(item(items, "usb").values.at("speed_mbit_s"), 5000.0);
}

TEST_F(ComputerCheckup, FindsAUserWhoIsNotInTheGroup) {
  restrict("dev/video2");
  restrict("dev/ttyACM0");
  const CheckedItems items = examine();
  EXPECT_EQ(state(items, "camera-rights"), "failed");
  EXPECT_THAT(item(items, "camera-rights").result, HasSubstr("video2 of the camera may not be opened"));
  EXPECT_EQ(state(items, "robot-rights"), "failed");
  if (getuid() == 0) {
    EXPECT_THAT(item(items, "robot-rights").advice, HasSubstr("sudo adduser root dialout"));
  }
}

TEST_F(ComputerCheckup, FindsThatNoGroupMayOpenIt) {
  restrict("dev/bus/usb/002/007", false);
  const CheckedItems items = examine();
  EXPECT_EQ(state(items, "camera-rights"), "failed");
  EXPECT_THAT(item(items, "camera-rights").advice, HasSubstr("install rva-server"));
}

TEST_F(ComputerCheckup, FindsUsb2) {
  plug_in("480");
  const CheckedItems items = examine();
  EXPECT_EQ(state(items, "usb"), "warning");
  EXPECT_THAT(item(items, "usb").result, HasSubstr("USB 2"));
  EXPECT_THAT(item(items, "usb").advice, HasSubstr("USB 3 cable"));
}

TEST_F(ComputerCheckup, FindsThatRulesAreMissing) {
  fs::rename(folder_ / "rules/60-rva-server.rules", folder_ / "rules/60-rva-server.rules.dpkg-old");
  EXPECT_EQ(state(examine(), "udev-rules"), "warning");
  write("rules/99-realsense-libusb.rules", "");
  EXPECT_THAT(item(examine(), "udev-rules").result, HasSubstr("for cameras alone"));
}

TEST_F(ComputerCheckup, NamesThePortsThatThereAre) {
  fs::rename(folder_ / "dev/ttyACM0", folder_ / "dev/ttyUSB3");
  const CheckedItems items = examine();
  EXPECT_EQ(state(items, "robot-rights"), "failed");
  EXPECT_THAT(item(items, "robot-rights").advice, HasSubstr("ttyUSB3"));
}

TEST_F(ComputerCheckup, LeavesOutWhatIsNotUsed) {
  const CheckedItems items = examine_computer({false, "", folder_ / "data", 0.0}, folders_);
  for (const char* const name : {"udev-rules", "camera-rights", "usb", "robot-rights"})
    EXPECT_EQ(state(items, name), "not-tried");
  fs::remove_all(folder_ / "sys/bus");
  EXPECT_EQ(state(examine(), "usb"), "not-tried");
}

TEST_F(ComputerCheckup, FindsADiskThatIsFullAndAFolderThatCannotBeMade) {
  EXPECT_EQ(state(examine(1e6), "disk"), "failed");
  const CheckedItems items =
      examine_computer({false, "", folder_ / "dev/ttyACM0/data", 0.0}, folders_);  // a file is in the way
  EXPECT_EQ(state(items, "data-folder"), "failed");
  EXPECT_EQ(state(examine_computer({false, "", folder_ / "new/data", 0.0}, folders_), "data-folder"), "ok");
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

}  // namespace
}  // namespace rva
