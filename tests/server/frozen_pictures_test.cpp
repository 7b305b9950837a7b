#include "server/frozen_pictures.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(FrozenPictures, TheLastOnesAreKept) {
  FrozenPictures frozen;
  EXPECT_EQ(frozen.find(0), nullptr);
  EXPECT_EQ(frozen.find(1), nullptr);
  for (int number = 1; number <= static_cast<int>(FrozenPictures::most) + 2; ++number) {
    FrozenPicture picture;
    picture.picture = ColorImage(number, 1);
    EXPECT_EQ(frozen.add(std::move(picture)), number);
  }
  EXPECT_EQ(frozen.find(2), nullptr) << "dropped";
  for (int number = 3; number <= static_cast<int>(FrozenPictures::most) + 2; ++number)
    EXPECT_EQ(frozen.find(number)->picture.width(), number);
  EXPECT_EQ(frozen.find(99), nullptr);
  EXPECT_EQ(frozen.find(-1), nullptr);
}

}  // namespace
}  // namespace rva
