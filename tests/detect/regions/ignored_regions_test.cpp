#include "detect/regions/ignored_regions.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/image_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

std::size_t count(const Mask& mask) {
  return static_cast<std::size_t>(std::ranges::count(mask.pixels(), mask_set));
}

TEST(IgnoredRegions, APixelIsLeftOutByItsCentre) {
  const Mask mask = mask_of({{{{1.5, 0.5}, {4.5, 0.5}, {4.5, 2.5}, {1.5, 2.5}}}, {}}, 8, 6);
  EXPECT_EQ(count(mask), 6U);
  EXPECT_EQ(mask(2, 1), mask_set);
  EXPECT_EQ(mask(4, 2), mask_set);
  EXPECT_EQ(mask(5, 2), 0);
  const Mask triangle = mask_of({{{{0, 0}, {4, 0}, {0, 4}}}, {}}, 8, 6);
  EXPECT_EQ(count(triangle), 15U) << "centres on an edge count";
}

TEST(IgnoredRegions, ConcavePolygonsAreNotFilledAcross) {
  const Polygon u_shape{{0, 0}, {1, 0}, {1, 4}, {4, 4}, {4, 0}, {5, 0}, {5, 5}, {0, 5}};
  const Mask mask = mask_of({{u_shape}, {}}, 8, 8);
  EXPECT_EQ(mask(2, 1), 0);
  EXPECT_EQ(mask(0, 2), mask_set);
  EXPECT_EQ(mask(3, 5), mask_set);
}

TEST(IgnoredRegions, WithinLeavesOutTheRestAndIgnoreAddsToIt) {
  const Box inner{2, 1, 4, 3};
  EXPECT_EQ(count(mask_of({{}, {polygon_of(inner)}}, 10, 8)), 80U - 12U);
  EXPECT_EQ(count(mask_of({{polygon_of({3, 1, 1, 1})}, {polygon_of(inner)}}, 10, 8)), 80U - 11U);
  EXPECT_EQ(count(mask_of({{}, {polygon_of(inner), polygon_of({8, 6, 2, 2})}}, 10, 8)), 80U - 16U);
  EXPECT_TRUE(mask_of({}, 10, 8).empty());
}

TEST(IgnoredRegions, WhatLiesOutsideTheImageIsCutOff) {
  EXPECT_EQ(count(mask_of({{{{-50, -50}, {500, -50}, {500, 500}, {-50, 500}}}, {}}, 10, 8)), 80U);
  EXPECT_EQ(count(mask_of({{{{-50, -50}, {-20, -50}, {-20, -20}}}, {}}, 10, 8)), 0U);
}

TEST(IgnoredRegions, ComeBackFromTheirFile) {
  const IgnoredRegions regions{{{{0.5, 1}, {3, 1.25}, {2, 7}}}, {polygon_of({1, 2, 3, 4})}};
  EXPECT_EQ(parse_regions(json_text(json_of(regions)), "file"), regions);
}

TEST(IgnoredRegions, MalformedFilesAreRefused) {
  const auto refused = [](const std::string& text) {
    EXPECT_THROW(static_cast<void>(parse_regions(text, "file")), Error) << text;
  };
  refused("{");
  refused("[]");
  refused(R"({"format":"rva-regions"})");
  refused(R"({"format":"rva-regions","version":2,"ignore":[]})");
  const auto regions = [](const std::string& ignore) {
    return R"({"format":"rva-regions","version":1,"ignore":)" + ignore + "}";
  };
  for (const char* const ignore : {"7", "[7]", "[[[1,2],[3,4]]]", "[[[1,2],[3,4],[5]]]",
                                   "[[[1,2],[3,4],[5,\"6\"]]]", "[[[1,2],[3,4],[5,1e300]]]"})
    refused(regions(ignore));
  EXPECT_TRUE(parse_regions(regions("[]"), "file").empty());
}

TEST(IgnoredRegions, APictureLeavesOutWhatIsNotBlack) {
  const test::TemporaryFolder folder;
  Mask drawn(10, 8);
  drawn(3, 2) = 1;
  drawn(4, 2) = 255;
  write_file(folder / "mask.png", encode_png(drawn));
  EXPECT_EQ(count(read_ignored_mask(folder / "mask.png", 10, 8)), 2U);
  EXPECT_THROW(static_cast<void>(read_ignored_mask(folder / "mask.png", 8, 10)), Error) << "of another size";
  EXPECT_THROW(static_cast<void>(read_ignored_mask(folder / "none.png", 10, 8)), Error);
  write_file(folder / "regions.json", json_text(json_of(IgnoredRegions{{polygon_of({0, 0, 2, 2})}, {}})));
  EXPECT_EQ(count(read_ignored_mask(folder / "regions.json", 10, 8)), 4U);
}

}  // namespace
}  // namespace rva
