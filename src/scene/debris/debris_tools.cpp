#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "scene/debris/debris_shapes.hpp"
#include "scene/solids/shapes.hpp"
#include "scene/solids/skin.hpp"

namespace rva {
namespace {

constexpr int round = 32;
constexpr int small_round = 16;

TriangleMesh along_x(const TriangleMesh& mesh_along_z) {
  return turned(mesh_along_z, 90, Eigen::Vector3d::UnitY());
}

Outline joined(std::initializer_list<Outline> pieces) {
  Outline all;
  for (const Outline& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

}  // namespace

Parts flashlight() {
  const TriangleMesh body = turned_solid({{13.5, 0},
                                          {15.0, 1.5},
                                          {15.0, 108},
                                          {19.0, 122},
                                          {19.0, 148.5},
                                          {18.0, 150},
                                          {16.5, 150},
                                          {16.5, 147},
                                          {0, 147}},
                                         round);
  const TriangleMesh grip = turned_hollow({{14.5, 30}, {15.5, 30.5}, {15.5, 92.5}, {14.5, 93}}, round);
  const TriangleMesh button = moved(cylinder(5.0, 3.0, small_round), {15.0, 0, 112});
  const TriangleMesh lens = moved(cylinder(16.0, 1.0, round), {0, 0, 147.0});
  return {part_of("black-anodised", body), part_of("black-rubber", grip), part_of("red-plastic", button),
          part_of("bare-aluminium", lens)};
}

Parts small_flashlight() {
  const TriangleMesh body = turned_solid(
      {{6.0, 0}, {7.0, 1.0}, {7.0, 68}, {9.0, 74}, {9.0, 91.5}, {8.5, 92}, {7.5, 92}, {7.5, 90}, {0, 90}},
      round);
  const TriangleMesh lens = moved(cylinder(7.2, 1.0, round), {0, 0, 90.0});
  return {part_of("black-anodised", body), part_of("bare-aluminium", lens)};
}

// The hexagonal collar at the front of the handle keeps it from rolling away.
Parts screwdriver() {
  const TriangleMesh grip = turned_solid(
      {{9, 0}, {13, 2}, {14.5, 8}, {14.5, 60}, {12, 70}, {11, 78}, {13, 84}, {13, 96}, {9, 100}, {6, 104}},
      24);
  const TriangleMesh collar = moved(prism(hexagon(16.0 * std::numbers::sqrt3), 8.0), {0, 0, 86});
  const TriangleMesh shaft = turned_solid({{3, 95}, {3, 200}, {2.6, 203}, {1.2, 210}}, small_round);
  return {part_of("red-plastic", grip), part_of("black-plastic", collar), part_of("steel", shaft)};
}

// Round bores replace the square and the hexagon, since a camera sees either as a dark hole.
Parts socket() {
  const TriangleMesh shell = turned_hollow({{7.0, 0},
                                            {11.5, 0},
                                            {12.0, 0.5},
                                            {12.0, 37.5},
                                            {11.5, 38},
                                            {9.3, 38},
                                            {9.3, 22},
                                            {5.0, 20},
                                            {5.0, 16},
                                            {7.0, 15}},
                                           round);
  return {part_of("steel", shell)};
}

// A jaw open to one side, a ring at the other end; 160 mm overall.
Parts wrench() {
  constexpr double jaw_radius = 14.5;
  constexpr double jaw_half_width = 6.5;
  constexpr double ring_x = 135.0;
  constexpr double ring_radius = 10.5;
  const Outline jaw_floor = arc({0, 0}, jaw_half_width, 90, -90, 8);
  const Outline outline = joined({arc({0, 0}, jaw_radius, 207, 340, 16),
                                  arc({ring_x, 0}, ring_radius, 205, 515, 24),
                                  arc({0, 0}, jaw_radius, 20, 153, 16),
                                  {{-jaw_radius + 1.58, jaw_half_width}},
                                  jaw_floor,
                                  {{-jaw_radius + 1.58, -jaw_half_width}}});
  const std::vector<Outline> bore{ellipse({ring_x, 0}, 6.9, 6.9, 12)};
  return fitted({part_of("steel", extrude(outline, bore, 6.0))}, 160.0);
}

// Two flutes wind up the rod once in six diameters; the point is a cone of 118 degrees.
Parts drill_bit(double diameter, double length, double flute_length) {
  constexpr int corners = 20;
  const double radius = diameter / 2;
  const double point_length = radius / std::tan(radians(59.0));
  const auto ring = [&](double z, double depth) {
    Ring points;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners;
      const double twist = 2.0 * std::numbers::pi * z / (6.0 * diameter);
      const double flute = std::clamp(std::cos(2.0 * (angle - twist)), 0.0, 1.0);
      const double r = radius * (1.0 - depth * flute);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    return points;
  };
  std::vector<Ring> rings{ring(0, 0), ring(length - flute_length, 0)};
  const double step = diameter / 2;
  for (double z = length - flute_length + step; z < length - point_length; z += step)
    rings.push_back(ring(z, 0.4));
  rings.push_back(ring(length - point_length, 0.4));
  rings.push_back({{0, 0, length}});
  return {part_of("steel", along_x(skin(rings)))};
}

Parts sheet_holder() {
  const TriangleMesh barrel =
      turned_solid({{5.2, 0}, {5.7, 0.5}, {5.7, 29.5}, {5.2, 30}, {3.6, 30.2}, {3.6, 34}}, 24);
  const TriangleMesh plunger =
      turned_solid({{3.2, -13}, {3.6, -12.5}, {3.6, -10}, {2.2, -9.5}, {2.2, 1}}, 24);
  const TriangleMesh needles = turned_solid({{2.3, 33}, {2.3, 43}, {1.6, 44}}, small_round);
  return {part_of("brass", barrel), part_of("steel", plunger), part_of("steel", needles)};
}

Parts pen() {
  const TriangleMesh barrel = turned_solid({{4.1, 0}, {4.1, 125}, {1.6, 136}}, 6);
  const TriangleMesh tip = turned_solid({{1.2, 135}, {1.0, 138}, {0.4, 143.5}, {0, 144}}, 12);
  const TriangleMesh plug = turned_solid({{3.6, -1}, {3.9, 0.5}}, 12);
  const TriangleMesh cap = turned_solid({{4.8, 92}, {5.0, 92.5}, {5.0, 140}, {3.5, 147.5}, {2.5, 148}}, 16);
  const TriangleMesh clip = moved(box({1.6, 3.2, 42}), {6.4, 0, 118});
  const TriangleMesh bridge = moved(box({3.0, 3.2, 5}), {5.2, 0, 136});
  return {part_of("white-plastic", barrel), part_of("steel", tip),         part_of("blue-plastic", plug),
          part_of("blue-plastic", cap),     part_of("blue-plastic", clip), part_of("blue-plastic", bridge)};
}

Parts key() {
  const Outline blade_below{{24.0, -4.0}, {57.0, -4.0}, {57.0, -1.0}};
  const Outline teeth{{55.0, 1.0}, {52.5, 3.5}, {50.5, 1.8}, {48.0, 3.8}, {45.5, 1.5}, {43.0, 3.5},
                      {40.5, 2.4}, {38.0, 3.9}, {35.5, 1.9}, {33.0, 4.0}, {24.0, 4.0}};
  const Outline outline = joined({blade_below, teeth, arc({12.5, 0}, 12.5, 22, 338, 28)});
  const std::vector<Outline> hole{ellipse({5.0, 0}, 3.0, 3.0, 16)};
  return {part_of("brass", extrude(outline, hole, 2.2))};
}

}  // namespace rva
