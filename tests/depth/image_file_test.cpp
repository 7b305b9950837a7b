#include "depth/image_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

DepthImage noisy_image(int width, int height) {
  std::mt19937 random(3);
  return test::random_stack({width, height, 1}, 30000, 30000, 0.1, random)[0];
}

TEST(ImageFile, DepthSurvivesEncoding) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {64, 48}, {129, 33}}) {
    const DepthImage image = noisy_image(width, height);
    EXPECT_EQ(decode_depth(encode_png(image), "image"), image);
  }
}

TEST(ImageFile, ColorSurvivesEncoding) {
  ColorImage image(31, 17);
  for (std::size_t i = 0; i < image.size(); ++i) {
    image[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(7 * i),
                static_cast<std::uint8_t>(i / 3)};
  }
  EXPECT_EQ(decode_color(encode_png(image), "image"), image);
}

TEST(ImageFile, GreyIsReadAsColor) {
  Mask mask(5, 4);
  mask(2, 1) = mask_set;
  const ColorImage image = decode_color(encode_png(mask), "image");
  EXPECT_EQ(image(2, 1), (Rgb{255, 255, 255}));
  EXPECT_EQ(image(1, 1), (Rgb{0, 0, 0}));
}

TEST(ImageFile, EveryTruncationIsRefused) {
  const std::vector<std::byte> png = encode_png(noisy_image(9, 5));
  for (std::size_t length = 0; length < png.size() - 4; ++length) {  // the end mark's checksum guards nothing
    EXPECT_THROW(static_cast<void>(decode_depth(std::span(png).first(length), "image")), Error) << length;
  }
}

TEST(ImageFile, EveryFlippedBitIsRefusedOrHarmless) {
  const DepthImage image = noisy_image(9, 5);
  const std::vector<std::byte> png = encode_png(image);
  for (std::size_t bit = 0; bit < 8 * png.size(); ++bit) {
    std::vector<std::byte> damaged = png;
    damaged[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    try {
      EXPECT_EQ(decode_depth(damaged, "image"), image) << "bit " << bit << " changed the image unnoticed";
    } catch (const Error&) {
      continue;
    }
  }
}

TEST(ImageFile, DepthHasOneChannelOfSixteenBits) {
  EXPECT_THROW(static_cast<void>(decode_depth(encode_png(Mask(4, 4)), "image")), Error);
  EXPECT_THROW(static_cast<void>(decode_depth(encode_png(ColorImage(4, 4)), "image")), Error);
}

TEST(ImageFile, OfColorWithSixteenBitsTheUpperEightAreTaken) {
  DepthImage grey(4, 4, 0x12FF);
  grey(1, 2) = 0xFE01;
  const ColorImage color = decode_color(encode_png(grey), "image");
  EXPECT_EQ(color(0, 0), (Rgb{0x12, 0x12, 0x12}));
  EXPECT_EQ(color(1, 2), (Rgb{0xFE, 0xFE, 0xFE}));
}

TEST(ImageFile, ErrorsNameTheFile) {
  try {
    static_cast<void>(decode_depth({}, "depth/000003.png"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.source(), "depth/000003.png");
  }
}

// A file of 62 KB can state an image that takes gigabytes to compare.
TEST(ImageFile, DepthLargerThanAnyCameraGivesIsRefused) {
  EXPECT_EQ(decode_depth(encode_png(DepthImage(4096, 2048)), "x").size(), std::size_t{max_depth_pixels});
  EXPECT_THAT([] { static_cast<void>(decode_depth(encode_png(DepthImage(4097, 2048)), "x")); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("larger than any camera")));
}

}  // namespace
}  // namespace rva
