#include <gtest/gtest.h>

namespace {

TEST(RealSense, NeedsLibrealsense2) {
  GTEST_SKIP() << "librealsense2 was not found, so nothing of RealSense cameras was built or tried";
}

}  // namespace
