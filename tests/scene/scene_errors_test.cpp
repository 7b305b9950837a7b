// What a scene file may not say, and where the complaint points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::bay_head;
using test::parsed;
using test::scene_head;
using testing::HasSubstr;
using testing::StartsWith;

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string complaint(const std::string& text, const SceneOverrides& overrides = {}) {
  return message_of([&] { static_cast<void>(parsed(text, overrides)); });
}

// What follows the two lines of scene_head, or the four of bay_head, and the complaint's beginning.
struct BadScene {
  std::string text;
  std::string complaint;
};

std::string solid(const std::string& fields) {
  return scene_head + "solids:\n  - { name: s, shape: box, at_m: [0, 5, 0], " + fields + " }\n";
}

std::string debris(const std::string& fields) { return bay_head + "debris:\n  - { " + fields + " }\n"; }

void expect_complaints(const std::vector<BadScene>& scenes) {
  for (const BadScene& scene : scenes)
    EXPECT_THAT(complaint(scene.text), StartsWith("scene.yaml:" + scene.complaint)) << scene.text;
}

TEST(SceneErrors, OfTheDocument) {
  expect_complaints({
      {"", "1: empty"},
      {scene_head + "---\n" + scene_head, "1: continues after the end of its YAML document"},
      {", a\n" + scene_head, "1: continues after the end of its YAML document"},
      {scene_head + "...\n# the end\nwing: {}", "1: continues after the end"},
      {"format: [", "1: not YAML"},
      {scene_head + "wing: {\n  span_m: }}\n", "4: not YAML"},
      {"just text", "1: not a list of `key: value`"},
      {std::string(2000, '['), "1: not YAML"},
      {"version: 1", "1: key \"format\" is missing"},
      {"format: rva-scene", "1: key \"version\" is missing"},
      {"format: rva-capture\nversion: 1", "1: field format: not \"rva-scene\""},
      {"format: rva-scene\nversion: 2", "2: field version: not 1"},
      {scene_head + "debri: []", "3: unknown key \"debri\"; known here: format, version, wing"},
      {scene_head + "wing: {}\nwing: {}", "4: key \"wing\" given twice"},
  });
  EXPECT_THAT(complaint("format: \xFF"), StartsWith("scene.yaml: not UTF-8 text"));
  EXPECT_THAT(complaint(std::string(2U << 20U, ' ')), StartsWith("scene.yaml: larger than 1 MB"));
}

TEST(SceneErrors, OfTheWing) {
  const auto wing = [](const std::string& fields) { return scene_head + "wing:\n  " + fields + "\n"; };
  expect_complaints({
      {scene_head + "wing:", "3: field wing: not a list of `key: value`"},
      {wing("span_m: -1"), "4: field wing.span_m: \"-1\" is out of range; use 0.1 to 20"},
      {wing("span_m: wide"), "4: field wing.span_m: \"wide\" is not a number"},
      {wing("span_m: .nan"), "4: field wing.span_m: \".nan\" is not a number"},
      {wing("span_m: inf"), "4: field wing.span_m: \"inf\" is not a number"},
      {wing("span_m: [1]"), "4: field wing.span_m: not a number"},
      {wing("stringers: { profile: t }"),
       "4: field wing.stringers.profile: unknown profile \"t\"; use one of: l, z, hat"},
      {wing("stringers: { count: 2.5 }"), "4: field wing.stringers.count: \"2.5\" is not a whole number"},
      {wing("stringers: { count: 40 }"),
       "4: field wing.stringers: stringers 50 mm wide do not fit 27 mm apart"},
      {wing("stringers: { height_mm: 400 }"), "4: field wing.stringers: stringers are as high as the bay"},
      {wing("stringers: { thickness_mm: 20 }"), "4: field wing.stringers: stringers' sheet is too thick"},
      {wing("chord_m: 0.2"), "4: field wing: stringers 50 mm wide"},
      {wing("ribs: { hole_diameter_mm: 360 }"), "4: field wing.ribs: lightening holes do not fit"},
      {wing("ribs: { material: gold }"), "4: field wing.ribs.material: unknown material \"gold\""},
      {wing("spars: { rear_height_mm: 400 }"), "4: field wing.spars: the rear spar is higher than the bay"},
      {wing("spars: { rear_height_mm: 15 }"), "4: field wing.spars: the rear spar is too low"},
      {wing("spars: { flange_mm: 400 }"), "4: field wing.spars: the spars' caps fill the bay"},
      {wing("skin: { upper: maybe }"), "4: field wing.skin.upper: \"maybe\" is not true or false"},
      {wing("access_hole: { width_mm: 800 }"), "4: field wing.access_hole: the access hole does not fit"},
      {wing("back_wall_m: 1"), "4: field wing: the back wall stands inside the wing"},
  });
}

TEST(SceneErrors, OfSolids) {
  expect_complaints({
      {scene_head + "solids: 5", "3: field solids: not a list"},
      {scene_head + "solids: [5]", "3: field solids[0]: key \"shape\" is missing"},
      {solid("size_mm: [1, 2], material: steel"), "4: field solids[0].size_mm: 2 entries, not 3"},
      {solid("size_mm: [1, 2, -3], material: steel"),
       "4: field solids[0].size_mm[2]: \"-3\" is out of range"},
      {solid("material: steel"), "4: field solids[0]: key \"size_mm\" is missing"},
      {solid("size_mm: [1, 2, 3]"), "4: field solids[0]: key \"material\" is missing"},
      {solid("size_mm: [1, 2, 3], material: jelly"),
       "4: field solids[0].material: unknown material \"jelly\""},
      {solid("radius_mm: 1"), "4: field solids[0]: unknown key \"radius_mm\""},
      {solid("size_mm: [1, 2, 3], material: steel, turn_deg: 5"), "4: field solids[0].turn_deg: not a list"},
      {solid("size_mm: [1, 2, 3], material: steel, debris: 2"),
       "4: field solids[0].debris: \"2\" is not true"},
      {scene_head + "solids: [{ shape: ball }]", "3: field solids[0].shape: unknown shape \"ball\""},
      {solid("size_mm: [1, 2, 3], material: steel") +
           "  - { name: s, shape: plane, size_mm: [1, 2], at_m: [0, 0, 0], material: steel }",
       "5: field solids[1].name: \"s\" is already the name of another object"},
      {bay_head +
           "solids: [{ name: rib-left, shape: plane, size_mm: [1, 2], at_m: [0, 0, 0], material: steel }]",
       "5: field solids[0].name: \"rib-left\" is already the name of another object"},
  });
}

TEST(SceneErrors, OfMeshes) {
  const test::TemporaryFolder folder;
  write_file(folder / "empty.stl", "solid nothing\nendsolid nothing\n");
  write_file(folder / "points.obj", "v 0 0 0\nv 1 0 0\n");
  write_file(folder / "huge.obj", "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nf 1 2 3\n");
  write_file(folder / "noise.stl", "not a mesh at all");
  const auto with = [&](const std::string& file, const std::string& unit = "m") {
    return message_of([&] {
      static_cast<void>(parse_scene(scene_head + "meshes:\n  - name: m\n    file: " + file + "\n    unit: " +
                                        unit + "\n    at_m: [0, 5, 0]\n    material: steel\n",
                                    folder / "scene.yaml"));
    });
  };
  const std::string place = (folder / "scene.yaml").string() + ":5: field meshes[0].file: ";
  EXPECT_THAT(with("none.stl"), AllOf(StartsWith(place), HasSubstr("none.stl no such file")));
  EXPECT_THAT(with("mesh.step"), AllOf(StartsWith(place), HasSubstr("not a supported mesh file")));
  EXPECT_THAT(with("empty.stl"), AllOf(StartsWith(place), HasSubstr("contains no triangles")));
  EXPECT_THAT(with("points.obj"), AllOf(StartsWith(place), HasSubstr("contains no triangles")));
  EXPECT_THAT(with("noise.stl"), AllOf(StartsWith(place), HasSubstr("contains no triangles")));
  EXPECT_THAT(with("huge.obj"), AllOf(StartsWith(place), HasSubstr("extends beyond 100 m")));
  EXPECT_THAT(with("huge.obj", "ft"), HasSubstr(":6: field meshes[0].unit: unknown unit \"ft\""));
}

TEST(SceneErrors, OfLightAndRobot) {
  expect_complaints({
      {scene_head + "light: { ambient: -1 }", "3: field light.ambient: \"-1\" is out of range"},
      {scene_head + "light: { visible: 2 }", "3: field light.visible: \"2\" is out of range"},
      {scene_head + "light: { lamps: [{ strength: 1 }] }",
       "3: field light.lamps[0]: key \"at_m\" is missing"},
      {scene_head + "robot: { base: \"\" }", "3: field robot.base: empty"},
      {scene_head + "robot: { tilt_deg: 120 }", "3: field robot.tilt_deg: \"120\" is out of range"},
      {scene_head + "robot: { pan: 5 }", "3: field robot: unknown key \"pan\""},
  });
}

TEST(SceneErrors, OfDebris) {
  expect_complaints({
      {debris("kind: hammer, on: [0, 0.47]"),
       "6: field debris[0].kind: unknown kind of debris \"hammer\"; use one of: "},
      {debris("on: [0, 0.47]"), "6: field debris[0]: key \"kind\" is missing"},
      {debris("kind: key"), "6: field debris[0]: key \"on\" is missing"},
      {debris("kind: key, on: [0, 0.47], at_m: [0, 0, 0]"), "6: field debris[0]: unknown key \"on\""},
      {debris("kind: key, on: [0, 0.47], resting: 99"), "6: field debris[0].resting: \"99\" is out of range"},
      {debris("kind: key, on: [0, 0.47], name: rib-left"),
       "6: field debris[0].name: \"rib-left\" is already the name of another object"},
      {debris("kind: key, on: [0, 0.54]"), "6: field debris[0].on: key does not come to rest there"},
      {debris("kind: key, on: [0, 50]"), "6: field debris[0].on: key does not come to rest there"},
      {debris("kind: key, on: [1.0, 0.5]"), "6: field debris[0].on: key lies outside the bay"},
      {debris("kind: key, at_m: [0, 0.5, 0.5]"), "6: field debris[0].at_m: key lies outside the bay"},
      {debris("random: 0"), "6: field debris[0].random: \"0\" is out of range"},
      {debris("random: 1, seed: -1"), "6: field debris[0].seed: \"-1\" is not a whole number"},
      {debris("random: 1, kinds: []"), "6: field debris[0].kinds: lists no kind"},
      {debris("random: 1, kinds: [key, hammer]"), "6: field debris[0].kinds[1]: unknown kind"},
      {debris("random: 1, within_m: [0, 1]"), "6: field debris[0].within_m[0]: not a list"},
      {debris("random: 1, within_m: [[0, 1]]"), "6: field debris[0].within_m: not two corners"},
      {debris("random: 2, kinds: [key], within_m: [[0, 0.45], [0.01, 0.46]]"),
       "6: field debris[0].random: found room for only 1 of 2"},
      {scene_head + "debris: [{ random: 1 }]",
       "3: field debris[0]: key \"within_m\" is missing where there is no wing"},
  });
}

TEST(SceneErrors, OfACameraInsideASolid) {
  const std::string blocked =
      scene_head +
      "robot:\n  at_m: [0, 0, 0]\n"
      "solids: [{ name: block, shape: box, size_mm: [400, 400, 400], at_m: [0, 0, 0.25],"
      " material: steel }]\n";
  EXPECT_THAT(complaint(blocked), AllOf(StartsWith("scene.yaml:4: field robot: the camera at"),
                                        HasSubstr("is inside \"block\"; move the robot elsewhere")));
  EXPECT_THAT(complaint(blocked, test::with_robot_at({0.1, 0, 0})), StartsWith("position: the camera at"));
  EXPECT_EQ(complaint(blocked, test::with_robot_at({0, 1, 0})), "accepted");
}

TEST(SceneErrors, OfADebrisFileNameThatFile) {
  const test::TemporaryFolder folder;
  write_file(folder / "debris.yaml", scene_head + "debris: [{ kind: hammer, on: [0, 0] }]\n");
  EXPECT_THAT(complaint(bay_head, test::with_debris_of(folder / "debris.yaml")),
              StartsWith((folder / "debris.yaml").string() + ":3: field debris[0].kind: unknown kind"));
  EXPECT_THAT(complaint(bay_head, test::with_debris_of(folder / "none.yaml")),
              HasSubstr("none.yaml: no such file"));
}

TEST(SceneErrors, StayOnOneLine) {
  const std::string message = complaint(scene_head + "\"a\\nb" + std::string(200, 'x') + "\": 1");
  EXPECT_THAT(message, StartsWith("scene.yaml:3: unknown key \"a\\x0Abxxx"));
  EXPECT_LT(message.size(), 250U);
}

}  // namespace
}  // namespace rva
