#include "sim/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "depth/image_file.hpp"
#include "tests/sim/small_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using Json = nlohmann::json;

class Truth : public testing::Test {
 protected:
  Truth() {
    scene_.objects.push_back(test::box_at("crate", {0.1, 0.62, 0.25}, {0.1, 0.2, 0.3}));
    scene_.objects.push_back(test::box_at("behind", {0, -5, 0.25}, {0.1, 0.1, 0.1}));
    scene_.objects[1].role = Role::room;
    scene_.objects[2].role = Role::debris;
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_ / "capture" / "truth" / name;
  }
  Json write() {
    const SimulatedCamera camera(scene_, {}, 1, ColorFrames::none);
    OutputFolder out(folder_ / "capture", {"truth/truth.json", "truth/*.png"}, Existing::replace);
    write_truth(camera, out);
    out.commit();
    view_ = camera.true_view();
    return Json::parse(read_text_file(file("truth.json")));
  }

  Scene scene_ = test::room_with_wall(1.0);
  test::TemporaryFolder folder_;
  TrueView view_;
};

TEST_F(Truth, ImagesAreWhatIsThere) {
  write();
  const DepthImage read = read_depth(file("labels.png"));
  EXPECT_TRUE(std::ranges::equal(read.pixels(), view_.labels.pixels()));
  const DepthImage depth = read_depth(file("depth.png"));
  ASSERT_TRUE(depth.same_size(view_.depth_m));
  for (std::size_t i = 0; i < depth.size(); ++i)
    ASSERT_NEAR(depth[i] * 1e-4, static_cast<double>(view_.depth_m[i]), 0.51e-4);
  EXPECT_EQ(depth(100, 100), 10000);
}

TEST_F(Truth, ObjectsAreDescribed) {
  const Json truth = write();
  EXPECT_EQ(truth["format"], "rva-truth");
  EXPECT_EQ(truth["scene"], "room");
  EXPECT_EQ(truth["depth_unit_m"], 0.0001);
  ASSERT_EQ(truth["objects"].size(), 3U);
  const Json& crate = truth["objects"][1];
  EXPECT_EQ(crate["label"], 2);
  EXPECT_EQ(crate["name"], "crate");
  EXPECT_EQ(crate["kind"], "box");
  EXPECT_EQ(crate["world_from_object"][3], 0.1);
  const double size_mm[] = {100, 200, 300};
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(crate["size_mm"][axis].get<double>(), size_mm[axis], 1e-4);
  EXPECT_EQ(truth["objects"][0]["role"], "structure");
  EXPECT_EQ(crate["role"], "room");
  EXPECT_EQ(truth["objects"][2]["role"], "debris");
}

TEST_F(Truth, SaysWhereAnObjectIsSeen) {
  const Json crate = write()["objects"][1];
  const auto pixels = std::count(view_.labels.pixels().begin(), view_.labels.pixels().end(), 2);
  EXPECT_EQ(crate["visible_px"], pixels);
  // Its front is half a metre away, 100 mm wide and 300 mm high, 67.5 mm to the right of the imager, so that
  // its left side is seen back to where it ends, at 0.7 m.
  const double left = 423.5 + 425 * 0.0675 / 0.7;
  const double right = 423.5 + 425 * 0.1675 / 0.5;
  const double expected[] = {left, 239.5 - 425 * 0.15 / 0.5, right - left, 255};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(crate["bbox"][i].get<double>(), expected[i], 1.01) << i;
  const double side_px = 425 * (0.0675 / 0.5 - 0.0675 / 0.7) * (255 + 255 * 0.5 / 0.7) / 2;
  EXPECT_NEAR(static_cast<double>(pixels), 85 * 255 + side_px, 300);
}

TEST_F(Truth, AnObjectOutOfSightHasNoPositionInTheImage) {
  const Json behind = write()["objects"][2];
  EXPECT_EQ(behind["visible_px"], 0);
  EXPECT_FALSE(behind.contains("bbox"));
}

TEST_F(Truth, WhatIsTooFarForSixteenBitsHasNoDepth) {
  scene_ = test::room_with_wall(6.6);
  write();
  EXPECT_EQ(read_depth(file("depth.png"))(424, 240), no_depth);
  EXPECT_EQ(read_depth(file("labels.png"))(424, 240), 1);
}

TEST_F(Truth, NamesNeedNotBeUtf8) {
  scene_.name = "bay\xFF";
  EXPECT_EQ(write()["scene"], "bay\xEF\xBF\xBD");
}

TEST_F(Truth, SaysWhatCannotBeWritten) {
  const SimulatedCamera camera(scene_, {}, 1, ColorFrames::none);
  const OutputFolder out(folder_ / "capture", {"truth/truth.json"}, Existing::refuse);
  write_file(out.path("truth"), "in the way");
  EXPECT_THROW(write_truth(camera, out), Error);
}

}  // namespace
}  // namespace rva
