#include <array>
#include <cmath>
#include <string_view>

#include "scene/debris/debris_shapes.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

constexpr int round = 32;
constexpr int small_round = 16;

TriangleMesh rotated_at_random(const TriangleMesh& mesh, Random& random) {
  const Eigen::Vector3d axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return turned(mesh, random.uniform(0, 360), axis.normalized());
}

// A box, cylinder, tube or cone whose largest extent is `size`.
TriangleMesh random_solid(double size, Random& random) {
  const double slim = size * random.uniform(0.1, 1.0);
  const double flat = size * random.uniform(0.1, 1.0);
  switch (random.bits() % 4) {
    case 0:
      return box({size, slim, flat});
    case 1:
      return cylinder(slim / 2, size, small_round);
    case 2:
      return tube(size / 2, size * random.uniform(0.2, 0.4), slim, round);
    default:
      return turned_solid({{slim / 2, 0}, {random.uniform(0.02, 0.98) * slim / 2, size}}, small_round);
  }
}

}  // namespace

Parts random_shape(Random& random) {
  constexpr std::array<std::string_view, 12> materials{
      "bare-aluminium", "steel",          "brass",        "black-anodised", "black-rubber", "black-plastic",
      "red-plastic",    "yellow-plastic", "blue-plastic", "white-plastic",  "wood",         "paper"};
  const double size = 8.0 * std::pow(25.0, random.uniform());  // 8 to 200 mm, logarithmically
  const auto count = 1 + random.bits() % 3;
  Parts parts;
  for (std::uint64_t i = 0; i < count; ++i) {
    const TriangleMesh solid =
        rotated_at_random(random_solid(size * random.uniform(0.3, 1.0), random), random);
    const Eigen::Vector3d off(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                              random.uniform(-0.3, 0.3));
    parts.push_back(part_of(materials.at(random.bits() % materials.size()), moved(solid, size * off)));
  }
  return fitted(std::move(parts), size);
}

Parts spray_can() {
  const TriangleMesh can =
      turned_solid({{31, 0}, {32.5, 2}, {32.5, 140}, {25, 152}, {14, 156}, {14, 158}}, round);
  const TriangleMesh cap = turned_solid({{25, 152}, {25, 184}, {22, 188}}, round);
  return {part_of("blue-plastic", can), part_of("white-plastic", cap)};
}

Parts tape_measure() {
  Outline side{{-34, -30}, {34, -30}};
  const Outline back = arc({0, 0}, 36, 20, 160, 12);
  side.insert(side.end(), back.begin(), back.end());
  const TriangleMesh hook = moved(box({3, 12, 19}), {38, -27, 17});
  return {part_of("yellow-plastic", prism(side, 34)), part_of("steel", hook)};
}

Parts pliers() {
  const std::array<Eigen::Vector3d, 4> handle{{{0, 0, 0}, {-25, 9, 0}, {-70, 22, 0}, {-115, 17, 0}}};
  const TriangleMesh upper = rod(handle, 6, small_round);
  const TriangleMesh jaws = moved(box({52, 16, 9}), {24, 0, 0});
  const TriangleMesh joint = cylinder(12, 11, round);
  return {part_of("red-plastic", upper), part_of("red-plastic", turned(upper, 180, Eigen::Vector3d::UnitX())),
          part_of("steel", jaws), part_of("steel", joint)};
}

Parts battery() {
  const TriangleMesh body =
      turned_solid({{16, 0}, {16.5, 0.5}, {16.5, 57}, {15, 58}, {5, 58}, {5, 60}}, round);
  return {part_of("black-plastic", body)};
}

Parts paper_cup() {
  const TriangleMesh wall = turned_hollow({{28, 0}, {40, 92}, {41, 93}, {40, 94}, {39, 93}, {27, 1}}, round);
  return {part_of("paper", wall), part_of("paper", moved(cylinder(27.5, 1, round), {0, 0, 3}))};
}

Parts hex_key() {
  const std::array<Eigen::Vector3d, 4> path{{{0, 0, 0}, {88, 0, 0}, {94, 6, 0}, {94, 34, 0}}};
  return {part_of("black-anodised", rod(path, 3, 6))};
}

Parts mirror() {
  const TriangleMesh disc = moved(cylinder(19, 4, round), {0, 0, 2});
  const TriangleMesh rim = moved(tube(20.5, 18.5, 6, round), {0, 0, 2});
  const std::array<Eigen::Vector3d, 3> path{{{18, 0, 2}, {60, 0, 5}, {190, 0, 5}}};
  return {part_of("bare-aluminium", disc), part_of("black-plastic", rim),
          part_of("steel", rod(path, 2.5, small_round))};
}

Parts paint_brush() {
  const TriangleMesh handle = moved(box({120, 18, 10}), {-60, 0, 0});
  const TriangleMesh ferrule = moved(box({30, 40, 13}), {12, 0, 0});
  const TriangleMesh bristles = moved(box({45, 38, 10}), {48, 0, 0});
  return {part_of("wood", handle), part_of("steel", ferrule), part_of("fabric-grey", bristles)};
}

Parts hose_clamp() {
  const TriangleMesh band = tube(22, 21, 12, round);
  const TriangleMesh screw = turned(cylinder(4.5, 24, small_round), 90, Eigen::Vector3d::UnitX());
  return {part_of("steel", band), part_of("steel", moved(screw, {26, 0, 0}))};
}

Parts protective_cap() {
  return {
      part_of("red-plastic", turned_hollow({{9, 0}, {9, 22}, {12, 22}, {12, 25}, {8, 25}, {8, 1}}, round)),
      part_of("red-plastic", moved(cylinder(8.5, 2, round), {0, 0, 1}))};
}

}  // namespace rva
