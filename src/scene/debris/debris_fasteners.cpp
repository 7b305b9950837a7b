#include <array>

#include "scene/debris/debris_shapes.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

constexpr double mm_per_inch = 25.4;
constexpr int round = 48;  ///< facets around parts whose diameter matters
constexpr int small_round = 24;

}  // namespace

// Figure 3.10 of the thesis gives the diameter of the flange; the proportions are assumed.
Parts swaged_collar(double diameter_in) {
  const double d = diameter_in * mm_per_inch;
  const TriangleMesh collar = turned_hollow({{0.25 * d, 0.00 * d},
                                             {0.48 * d, 0.00 * d},
                                             {0.50 * d, 0.02 * d},
                                             {0.50 * d, 0.13 * d},
                                             {0.48 * d, 0.15 * d},
                                             {0.39 * d, 0.18 * d},
                                             {0.37 * d, 0.22 * d},
                                             {0.37 * d, 0.90 * d},
                                             {0.34 * d, 0.95 * d},
                                             {0.25 * d, 0.95 * d}},
                                            round);
  return {part_of("anodised-gold", collar)};
}

// The thread is a cylinder of its mean diameter: its 1 mm pitch is finer than a pixel.
Parts bolt_m6() {
  const TriangleMesh head = moved(prism(hexagon(10.0), 4.0), {0, 0, -4.0});
  const TriangleMesh shank =
      turned_solid({{3.0, -0.5}, {3.0, 12.0}, {2.68, 12.4}, {2.68, 29.2}, {1.9, 30.0}}, small_round);
  return {part_of("steel", head), part_of("steel", shank)};
}

Parts hi_lok() {
  const TriangleMesh pin = turned_solid(
      {{3.5, 0.0}, {3.8, 0.3}, {3.8, 1.2}, {2.4, 1.5}, {2.4, 11.0}, {2.1, 11.3}, {2.1, 17.6}, {1.7, 18.0}},
      small_round);
  return {part_of("bare-aluminium", pin)};
}

Parts nut_m6() {
  const std::vector<Outline> bore{ellipse({0, 0}, 2.68, 2.68, small_round)};
  return {part_of("steel", extrude(hexagon(10.0), bore, 5.2))};
}

Parts nut_plate() {
  constexpr double lug_distance = 8.75;  // from the middle; the rivets are 17.5 mm apart
  Outline base = arc({lug_distance, 0}, 3.75, -70, 70, 8);
  for (const auto& [center_x, radius, from_deg, to_deg] :
       {std::array<double, 4>{0.0, 6.0, 70, 110}, {-lug_distance, 3.75, 110, 250}, {0.0, 6.0, 250, 290}}) {
    const Outline next = arc({center_x, 0}, radius, from_deg, to_deg, 8);
    base.insert(base.end(), next.begin(), next.end());
  }
  const std::vector<Outline> holes{ellipse({-lug_distance, 0}, 1.25, 1.25, 16), ellipse({0, 0}, 2.3, 2.3, 16),
                                   ellipse({lug_distance, 0}, 1.25, 1.25, 16)};
  const TriangleMesh barrel =
      turned_hollow({{2.4, 0.5}, {4.2, 0.5}, {4.0, 6.2}, {3.6, 6.8}, {2.4, 6.8}}, small_round);
  return {part_of("steel", extrude(base, holes, 1.0)), part_of("steel", barrel)};
}

Parts rivet() {
  const TriangleMesh solid = turned_solid(
      {{0, -1.7}, {1.4, -1.6}, {2.6, -1.25}, {3.5, -0.6}, {3.95, 0.0}, {1.98, 0.0}, {1.98, 9.4}, {1.85, 9.5}},
      small_round);
  return {part_of("anodised-aluminium", solid)};
}

Parts washer_m6() { return {part_of("steel", tube(6.0, 3.2, 1.6, round))}; }

}  // namespace rva
