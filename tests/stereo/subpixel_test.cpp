#include "stereo/subpixel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/stereo/random_images.hpp"

namespace rva {
namespace {

constexpr int width = 140;
constexpr int height = 80;
constexpr double blob_px = 1.5;
constexpr SubpixelOptions fine{.fraction_bits = 8};  // rounding would hide what the fit does

const test::BlobTexture& texture() {
  static const test::BlobTexture blobs(width, height, blob_px, 1);
  return blobs;
}

test::StereoPair pair_at(double disparity) {
  return {texture().seen(width, height, 0.0), texture().seen(width, height, disparity)};
}

Image<std::uint16_t> refine(const test::StereoPair& pair, int whole, const SubpixelOptions& options = fine) {
  const Image<std::uint8_t> start(width, height, static_cast<std::uint8_t>(whole));
  return refine_disparity(pair.left, pair.right, start, options);
}

struct Answer {
  double mean = 0.0;
  double deviation = 0.0;
  double found = 0.0;  // share of pixels
};

/// Of the pixels whose windows see the same in both images.
Answer answer_of(const Image<std::uint16_t>& refined, int fraction_bits = fine.fraction_bits) {
  std::vector<double> disparities;
  int pixels = 0;
  for (int v = 8; v < height - 8; ++v) {
    for (int u = 30; u < width - 10; ++u, ++pixels) {
      if (refined(u, v) != 0) disparities.push_back(std::ldexp(refined(u, v), -fraction_bits));
    }
  }
  const auto count = static_cast<double>(disparities.size());
  Answer answer{.found = count / pixels};
  for (const double disparity : disparities) answer.mean += disparity / count;
  for (const double disparity : disparities)
    answer.deviation += (disparity - answer.mean) * (disparity - answer.mean) / count;
  answer.deviation = std::sqrt(answer.deviation);
  return answer;
}

TEST(Subpixel, FindsFractionsOfAPixel) {
  std::vector<double> biases;
  for (const double disparity : {10.0, 10.13, 10.25, 10.5, 10.77}) {
    const Answer answer = answer_of(refine(pair_at(disparity), static_cast<int>(std::lround(disparity))));
    EXPECT_GT(answer.found, 0.98) << disparity;
    EXPECT_NEAR(answer.mean, disparity, 0.02);
    EXPECT_LT(answer.deviation, 0.06) << disparity;
    biases.push_back(answer.mean - disparity);
  }
  // Locking to whole pixels: fractions that are drawn to them, by more than others.
  const auto [least, greatest] = std::minmax_element(biases.begin(), biases.end());
  EXPECT_LT(*greatest - *least, 0.03);
}

// As sharp as the projector's dots are on the imagers: interpolation pushes answers off the whole pixels.
TEST(Subpixel, SharpDotsLockByLessThanAThirtiethOfAPixel) {
  const test::BlobTexture sharp(width, height, 0.95, 1);
  for (const double disparity : {10.0, 10.125, 10.25, 10.375, 10.625, 10.75, 10.875}) {
    const test::StereoPair pair{sharp.seen(width, height, 0.0), sharp.seen(width, height, disparity)};
    EXPECT_NEAR(answer_of(refine(pair, static_cast<int>(std::lround(disparity)))).mean, disparity, 0.033);
  }
}

TEST(Subpixel, ComesToTheSameFromEitherSide) {
  const test::StereoPair pair = pair_at(10.5);
  EXPECT_NEAR(answer_of(refine(pair, 10)).mean, answer_of(refine(pair, 11)).mean, 0.01);
}

TEST(Subpixel, TheWholeImagesBrightnessAndContrastDoNotMatter) {
  const test::StereoPair plain = pair_at(10.25);
  for (const auto& [gain, offset] : {std::pair{1.0, 150}, {1.0, -80}, {0.8, 60}, {1.2, -50}}) {
    test::StereoPair pair = plain;
    for (std::uint16_t& pixel : pair.right.pixels())
      pixel = static_cast<std::uint16_t>(std::clamp(std::lround(gain * pixel + offset), 0L, 1023L));
    EXPECT_NEAR(answer_of(refine(pair, 10)).mean, 10.25, 0.02) << gain << " " << offset;
  }
}

TEST(Subpixel, AnAddedConstantChangesNoPixel) {
  const test::StereoPair plain = pair_at(10.25);
  test::StereoPair pair = plain;
  for (std::uint16_t& pixel : pair.right.pixels()) pixel = static_cast<std::uint16_t>(pixel / 2);
  test::StereoPair brighter = pair;
  for (std::uint16_t& pixel : brighter.right.pixels()) pixel = static_cast<std::uint16_t>(pixel + 500);
  EXPECT_EQ(refine(pair, 10), refine(brighter, 10));
}

TEST(Subpixel, NoiseWidensButDoesNotShift) {
  const test::StereoPair plain = pair_at(10.25);
  const test::StereoPair pair{test::noisy(plain.left, 10.0, 2), test::noisy(plain.right, 10.0, 3)};
  const Answer answer = answer_of(refine(pair, 10));
  EXPECT_NEAR(answer.mean, 10.25, 0.02);
  EXPECT_GT(answer.deviation, answer_of(refine(plain, 10)).deviation);
  EXPECT_LT(answer.deviation, 0.1);
}

TEST(Subpixel, AnswersInThirtySecondsOfAPixel) {
  const Answer answer = answer_of(refine(pair_at(10.25), 10, {}), 5);
  EXPECT_NEAR(answer.mean, 10.25, 0.02);
}

TEST(Subpixel, FlatIsNoAnswer) {
  const InfraredImage flat(width, height, 300);
  EXPECT_EQ(refine({flat, flat}, 10), Image<std::uint16_t>(width, height, 0));
  // A brightness that grows along the row looks the same wherever it lies.
  InfraredImage ramp(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) ramp(u, v) = static_cast<std::uint16_t>(7 * u);
  }
  EXPECT_EQ(refine({ramp, ramp}, 10)(70, 40), 0);
}

TEST(Subpixel, NoMatchIsNoAnswer) {
  EXPECT_EQ(refine(pair_at(10.0), no_match), Image<std::uint16_t>(width, height, 0));
}

TEST(Subpixel, NeverLeavesTheWholePixelByMoreThanOne) {
  const test::StereoPair strangers{test::white_image(width, height, 4), test::white_image(width, height, 5)};
  Image<std::uint8_t> start(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u)
      start(u, v) = static_cast<std::uint8_t>((u + 7 * v) % (std::min(u, 126) + 1));
  }
  const Image<std::uint16_t> refined = refine_disparity(strangers.left, strangers.right, start, fine);
  int answers = 0;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    if (refined[i] == 0) continue;
    ++answers;
    ASSERT_LE(std::abs(refined[i] - 256 * start[i]), 256);
  }
  EXPECT_GT(answers, width * height / 10);
  EXPECT_LT(answers, width * height);
}

TEST(Subpixel, DoesNotFollowAMatchThatIsWrong) { EXPECT_LT(answer_of(refine(pair_at(10.0), 14)).found, 0.7); }

}  // namespace
}  // namespace rva
