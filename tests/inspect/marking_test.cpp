#include "inspect/marking.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr int width = 40;
constexpr int height = 30;

/// A capture of one depth image.
class OneImage : public Capture {
 public:
  OneImage(CaptureInfo info, DepthImage image) : Capture(std::move(info)), image_(std::move(image)) {}
  [[nodiscard]] std::size_t depth_frames() const override { return 1; }
  [[nodiscard]] std::size_t color_frames() const override { return 0; }
  [[nodiscard]] DepthImage depth(std::size_t /*i*/) const override { return image_; }
  [[nodiscard]] ColorImage color(std::size_t /*i*/) const override { return {}; }

 private:
  DepthImage image_;
};

// A wall at 1 m, with a box 800 mm away at u from 10 to 19, v from 10 to 19, and nothing measured right
// of 30.
std::unique_ptr<Capture> bay() {
  CaptureInfo info;
  info.depth = {width, height, 20.0, 25.0, 19.5, 14.5};
  DepthImage depth(width, height, 1000);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (u >= 10 && u < 20 && v >= 10 && v < 20) depth(u, v) = 800;
      if (u >= 30) depth(u, v) = no_depth;
    }
  }
  return std::make_unique<OneImage>(info, depth);
}

TEST(AMark, IsOnTheSurfaceInItsMiddle) {
  const MarkedFinding marked = located_mark(*bay(), {8, 8, 14, 14}, {});
  ASSERT_TRUE(marked.position_m);
  EXPECT_DOUBLE_EQ(marked.position_m->z(), 0.8);
  EXPECT_NEAR(marked.position_m->x(), (14.5 - 19.5) / 20.0 * 0.8, 1e-12);
  EXPECT_NEAR(marked.position_m->y(), (14.5 - 14.5) / 25.0 * 0.8, 1e-12);
  EXPECT_NEAR(marked.size_mm->at(0), 14 * 800.0 / 20.0, 1e-9);
  EXPECT_NEAR(marked.size_mm->at(1), 14 * 800.0 / 25.0, 1e-9);
  EXPECT_TRUE(marked.in_foot_m);
}

TEST(AMark, HasNoPositionWhereNothingIsMeasured) {
  const MarkedFinding marked = located_mark(*bay(), {31, 5, 8, 8}, {});
  EXPECT_EQ(marked.box, (Box{31, 5, 8, 8}));
  EXPECT_FALSE(marked.position_m || marked.in_foot_m || marked.size_mm);
}

TEST(AMark, OfOnePixelIsEnough) {
  EXPECT_DOUBLE_EQ(located_mark(*bay(), {12, 12, 1, 1}, {}).position_m->z(), 0.8);
}

TEST(AMark, IsInsideThePicture) {
  constexpr int most = std::numeric_limits<int>::max();
  for (const Box& box :
       {Box{-1, 0, 5, 5}, Box{0, -1, 5, 5}, Box{36, 0, 5, 5}, Box{0, 26, 5, 5}, Box{0, 0, 0, 5},
        Box{0, 0, 5, 0}, Box{0, 0, -5, 5}, Box{most, 0, 5, 5}, Box{5, 5, most, most}})
    EXPECT_THROW(static_cast<void>(located_mark(*bay(), box, {})), Error) << box.x << ' ' << box.width;
  EXPECT_NO_THROW(static_cast<void>(located_mark(*bay(), {0, 0, width, height}, {})));
}

TEST(MarkedPictures, AreNeverReplaced) {
  const test::TemporaryFolder data;
  const InspectionFolder folder(data.path(), 1);
  const std::string first = keep_picture(folder, InspectionFolder::marks_name, ColorImage(4, 4));
  const auto bytes = read_file(folder.path() / first);
  const std::string second =
      keep_picture(folder, InspectionFolder::marks_name, ColorImage(8, 4, Rgb{1, 2, 3}));
  EXPECT_NE(first, second);
  EXPECT_EQ(read_file(folder.path() / first), bytes);
  EXPECT_NE(read_file(folder.path() / second), bytes);
}

TEST(MarkedPictures, AreNotWrittenThroughALink) {
  const test::TemporaryFolder data;
  const InspectionFolder folder(data.path(), 1);
  std::filesystem::create_directories(folder.path());
  std::filesystem::create_directory(data / "elsewhere");
  std::filesystem::create_directory_symlink(data / "elsewhere", folder.path() / "marks");
  EXPECT_THROW(static_cast<void>(keep_picture(folder, InspectionFolder::marks_name, ColorImage(4, 4))),
               Error);
  EXPECT_TRUE(std::filesystem::is_empty(data / "elsewhere"));
}

}  // namespace
}  // namespace rva
