#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "camera/realsense/realsense.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

// Both where a camera is plugged in, which the message names, and where none is.
auto names_the_missing_library() {
  return testing::AllOf(testing::Property(&Error::problem, testing::HasSubstr("built without librealsense2")),
                        testing::Property(&Error::remedy, testing::HasSubstr("install librealsense2-dev")));
}

TEST(WithoutRealSense, TheMissingLibraryIsNamed) {
  EXPECT_FALSE(has_realsense());
  EXPECT_THAT([] { static_cast<void>(realsense_cameras()); },
              testing::Throws<Error>(names_the_missing_library()));
  EXPECT_THAT([] { static_cast<void>(open_realsense("12345")); },
              testing::Throws<Error>(names_the_missing_library()));
}

TEST(WithoutRealSense, OptionsAreCheckedAllTheSame) {
  RealSenseOptions options;
  options.exposure_us = -1.0;
  EXPECT_THAT([&] { static_cast<void>(open_realsense("", options)); },
              testing::Throws<UsageError>(testing::Property(&Error::source, testing::HasSubstr("exposure"))));
}

}  // namespace
}  // namespace rva
