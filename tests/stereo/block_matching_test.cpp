#include "stereo/block_matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/stereo/random_images.hpp"
#include "tests/stereo/slow_matcher.hpp"

namespace rva {
namespace {

constexpr int width = 96;
constexpr int height = 24;

/// Expects the same at every pixel. @return how many pixels have a match
int expect_same(const test::StereoPair& pair, const BlockMatchingOptions& options) {
  const test::SlowMatcher slow(pair, options);
  const Image<std::uint8_t> fast = match_blocks(pair.left, pair.right, options);
  int matches = 0;
  int differences = 0;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      differences += fast(u, v) == slow.match(u, v) ? 0 : 1;
      matches += fast(u, v) == no_match ? 0 : 1;
    }
  }
  EXPECT_EQ(differences, 0) << "search " << options.search_px << ", window " << options.window_px;
  return matches;
}

TEST(BlockMatching, AgreesWithTheDefinitionAtEveryPixel) {
  const test::StereoPair clean = test::shifted_pair(width, height, 17, 1);
  const test::StereoPair pair{test::noisy(clean.left, 150.0, 2), test::noisy(clean.right, 150.0, 3)};
  const int matches = expect_same(pair, {.search_px = 40});
  EXPECT_GT(matches, width * height / 2);
  EXPECT_LT(matches, width * height);
}

TEST(BlockMatching, AgreesOnImagesThatHaveNothingInCommon) {
  const test::StereoPair pair{test::white_image(width, height, 4), test::white_image(width, height, 5)};
  EXPECT_GT(expect_same(pair, {.search_px = 40, .uniqueness = 0.0, .left_right_px = 3}), 0);
}

TEST(BlockMatching, AgreesWithAllOptions) {
  const test::StereoPair clean = test::shifted_pair(width, height, 6, 6);
  const test::StereoPair pair{clean.left, test::noisy(clean.right, 250.0, 7)};
  for (const BlockMatchingOptions& options :
       {BlockMatchingOptions{.search_px = 95, .window_px = 3},
        {.search_px = 1},
        {.search_px = 12},
        {.search_px = 40, .window_px = 5, .census_threshold = 100, .uniqueness = 0.2, .left_right_px = 0},
        {.search_px = 30, .window_px = 1, .census_threshold = 0, .uniqueness = 0.0, .left_right_px = 2}})
    expect_same(pair, options);
}

TEST(BlockMatching, FindsTheShift) {
  for (const int shift : {1, 7, 40}) {
    const test::StereoPair pair = test::shifted_pair(width, height, shift, 8);
    const Image<std::uint8_t> found = match_blocks(pair.left, pair.right, {.search_px = 40});
    for (int v = 0; v < height; ++v) {
      for (int u = shift + 4; u < width - 4; ++u) ASSERT_EQ(found(u, v), shift) << u << " " << v;
    }
  }
}

TEST(BlockMatching, SeesNothingNearerThanItSearches) {
  const test::StereoPair pair = test::shifted_pair(width, height, 41, 9);
  const Image<std::uint8_t> wide = match_blocks(pair.left, pair.right, {.search_px = 41});
  const Image<std::uint8_t> narrow = match_blocks(pair.left, pair.right, {.search_px = 40});
  EXPECT_EQ(wide(70, 12), 41);
  EXPECT_LE(*std::max_element(narrow.pixels().begin(), narrow.pixels().end()), 40);
}

TEST(BlockMatching, FlatImagesHaveNoMatch) {
  for (const int search_px : {1, 40, 126}) {
    const InfraredImage flat(width, height, 300);
    EXPECT_EQ(match_blocks(flat, flat, {.search_px = search_px}),
              Image<std::uint8_t>(width, height, no_match));
  }
}

TEST(BlockMatching, RepeatingImagesHaveNoMatch) {
  InfraredImage stripes(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) stripes(u, v) = u % 8 < 4 ? 100 : 900;
  }
  const Image<std::uint8_t> found = match_blocks(stripes, stripes, {.search_px = 40});
  for (int v = 0; v < height; ++v) {
    for (int u = 24; u < width - 8; ++u) ASSERT_EQ(found(u, v), no_match) << u << " " << v;
  }
}

// Everything differs there: the greatest cost there is, which must not pass for a small one.
TEST(BlockMatching, ANegativeIsNoMatch) {
  test::StereoPair pair = test::shifted_pair(width, height, 20, 10);
  for (std::uint16_t& pixel : pair.right.pixels()) pixel = static_cast<std::uint16_t>(1023 - pixel);
  for (const int window_px : {9, 15}) {
    const Image<std::uint8_t> found =
        match_blocks(pair.left, pair.right, {.search_px = 40, .window_px = window_px});
    EXPECT_EQ(std::count(found.pixels().begin(), found.pixels().end(), 20), 0);
  }
}

}  // namespace
}  // namespace rva
