#include "server/private_paths.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(PrivatePaths, OfTheDataFolderTheInspectionStays) {
  EXPECT_EQ(without_folders("/srv/rva/data/inspections/000001/final-2/000: has 8 frames, not 10"),
            "inspections/000001/final-2/000: has 8 frames, not 10");
  EXPECT_EQ(
      without_folders("/home/my data/inspections/000001/final: remove /home/my data/inspections/000001/x"),
      "inspections/000001/final: remove inspections/000001/x");
  EXPECT_EQ(without_folders("remove /a/inspections/000012/initial/000 and resume"),
            "remove inspections/000012/initial/000 and resume");
}

TEST(PrivatePaths, OfOtherFilesTheNameStays) {
  EXPECT_EQ(without_folders("/srv/rva/data/rva.db: cannot be written"), "…/rva.db: cannot be written");
  EXPECT_EQ(without_folders("give '/etc/tls/key.pem' (/root/x)"), "give '…/key.pem' (…/x)");
}

TEST(PrivatePaths, OtherWordsStay) {
  for (const char* const text :
       {"", "camera: gives no frames; check its cable", "and/or", "/dev/ttyACM0: the robot is away",
        "/dev/serial/by-id/usb-1: x", "1/2", "/", "640 x 480 pixels, 30.0 frames a second"})
    EXPECT_EQ(without_folders(text), text);
}

}  // namespace
}  // namespace rva
