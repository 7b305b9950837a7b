#include "detect/genuine_captures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <random>

#include "core/error.hpp"
#include "detect/detect.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using Frames = std::vector<DepthImage>;
using testing::AllOf;
using testing::HasSubstr;

Frames noisy(int frames, unsigned seed) {
  std::mt19937 random(seed);
  return test::random_stack({40, 30, frames}, 1000, 3, 0.05, random);
}

Frames frozen(int frames, unsigned seed) {
  return {static_cast<std::size_t>(frames), noisy(1, seed).front()};
}

Captures captures_of(const std::vector<Frames>& side) {
  Captures captures;
  for (const Frames& frames : side)
    captures.push_back(std::make_unique<test::MemoryCapture>(test::info_of(40, 30), frames));
  return captures;
}

/// The refusal; empty where there is none.
std::string refusal(const std::vector<Frames>& initial, const std::vector<Frames>& final,
                    std::size_t frames = 0) {
  try {
    require_genuine(captures_of(initial), captures_of(final), frames);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(GenuineCaptures, AreAccepted) {
  EXPECT_EQ(refusal({noisy(4, 1)}, {noisy(4, 2)}), "");
  EXPECT_EQ(refusal({noisy(4, 1), noisy(4, 2)}, {noisy(4, 3), noisy(4, 4)}), "");
  EXPECT_EQ(refusal({noisy(1, 1)}, {noisy(1, 2)}), "") << "a single frame shows nothing of a frozen camera";
}

TEST(GenuineCaptures, OneDifferentPixelOfOneFrameSuffices) {
  Frames almost = frozen(9, 1);
  almost.back()(39, 29) ^= 1U;
  EXPECT_EQ(refusal({almost}, {noisy(9, 2)}), "");
  Frames almost_copy = noisy(9, 2);
  almost_copy.back()(0, 0) ^= 1U;
  EXPECT_EQ(refusal({almost_copy}, {noisy(9, 2)}), "");
}

TEST(GenuineCaptures, AFrozenCameraIsRefusedOnEitherSide) {
  const auto message =
      AllOf(HasSubstr("every frame is the same image: the camera was frozen"), HasSubstr("capture again"));
  EXPECT_THAT(refusal({frozen(4, 1)}, {noisy(4, 2)}), AllOf(HasSubstr("initial capture"), message));
  EXPECT_THAT(refusal({noisy(4, 1)}, {noisy(4, 2), frozen(2, 3)}),
              AllOf(HasSubstr("final capture"), message));
}

TEST(GenuineCaptures, OnlyFramesThatAreUsedCount) {
  Frames frozen_first = frozen(4, 1);
  for (DepthImage& frame : noisy(4, 2)) frozen_first.push_back(std::move(frame));
  EXPECT_EQ(refusal({frozen_first}, {noisy(8, 3)}), "");
  EXPECT_THAT(refusal({frozen_first}, {noisy(8, 3)}, 4), HasSubstr("frozen"));
  EXPECT_EQ(refusal({frozen_first}, {noisy(8, 3)}, 1), "");
}

TEST(GenuineCaptures, ACopyIsRefusedAlsoWithinASide) {
  EXPECT_THAT(refusal({noisy(4, 1)}, {noisy(4, 1)}),
              HasSubstr("the frames of both captures are identical, so one is a copy of the other"));
  EXPECT_THAT(refusal({noisy(1, 1)}, {noisy(1, 1)}), HasSubstr("copy"));
  EXPECT_THAT(refusal({noisy(4, 1)}, {noisy(3, 1)}), HasSubstr("copy")) << "though of fewer frames";
  EXPECT_THAT(refusal({noisy(4, 1), noisy(4, 2), noisy(4, 1)}, {noisy(4, 3)}),
              AllOf(HasSubstr("initial captures"), HasSubstr("identical")));
  EXPECT_THAT(refusal({noisy(4, 1), noisy(4, 2)}, {noisy(4, 3), noisy(4, 2)}),
              HasSubstr("initial and final"));
}

TEST(GenuineCaptures, ImagesWithoutAMeasurementAreNeither) {
  const Frames nothing(3, DepthImage(40, 30));
  EXPECT_EQ(refusal({nothing}, {nothing}), "");
}

TEST(GenuineCaptures, MethodsThatUseOneFrameDoNotNeedNoise) {
  const Captures still = captures_of({frozen(3, 1)});
  const Captures other = captures_of({noisy(3, 2)});
  const auto compare = [&](DetectionMethod method, const Captures& final) {
    DetectOptions options;
    options.method = method;
    return detect(still, final, options, {}).detection.findings.method;
  };
  EXPECT_EQ(compare(DetectionMethod::constant, other), "constant");
  for (const DetectionMethod method :
       {DetectionMethod::automatic, DetectionMethod::gaussian, DetectionMethod::calibrated})
    EXPECT_THROW(static_cast<void>(compare(method, other)), Error);
  EXPECT_THROW(static_cast<void>(compare(DetectionMethod::constant, captures_of({frozen(3, 1)}))), Error);
}

TEST(GenuineCaptures, PathsToOneFileAreRefused) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_directories(folder / "b");
  std::filesystem::create_directory_symlink(folder / "a", folder / "link");
  const auto given = [&](const std::vector<std::filesystem::path>& initial,
                         const std::vector<std::filesystem::path>& final) -> std::string {
    try {
      require_distinct(initial, final);
    } catch (const Error& error) {
      return error.problem();
    }
    return {};
  };
  EXPECT_EQ(given({folder / "a"}, {folder / "b"}), "");
  EXPECT_EQ(given({folder / "gone"}, {folder / "gone"}), "") << "opening it reports the reason";
  for (const char* same : {"a", "a/", "link", "b/../a"})
    EXPECT_EQ(given({folder / "a"}, {folder / "b", folder / same}), "both sides are the same capture")
        << same;
  EXPECT_EQ(given({folder / "a", folder / "link"}, {folder / "b"}), "is given twice for one side");
}

}  // namespace
}  // namespace rva
