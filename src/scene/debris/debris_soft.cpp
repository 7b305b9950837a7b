#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "scene/debris/debris_shapes.hpp"
#include "scene/solids/shapes.hpp"
#include "scene/solids/skin.hpp"

namespace rva {
namespace {

constexpr double pi = std::numbers::pi;

/// A strip that bends in the plane of x and z, by the angle `bend(i)` in radians at step i.
template <typename Bend>
TriangleMesh bent_strip(int steps, double step, double width, double thickness, Bend bend) {
  std::vector<Eigen::Vector3d> path;
  std::vector<Eigen::Vector3d> normals;
  Eigen::Vector3d point(0, 0, 0);
  double heading = 0.0;
  for (int i = 0; i <= steps; ++i) {
    path.push_back(point);
    normals.emplace_back(-std::sin(heading), 0, std::cos(heading));
    heading += bend(i) / 2;
    point += step * Eigen::Vector3d(std::cos(heading), 0, std::sin(heading));
    heading += bend(i) / 2;
  }
  return ribbon(path, normals, Eigen::Vector3d::UnitY(), width, thickness);
}

/// A capsule along z: a cylinder with hemispherical ends.
TriangleMesh capsule(double radius, double length) {
  constexpr int pieces = 5;
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = pi / 2 * i / pieces;
    profile.emplace_back(i == 0 ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  for (int i = pieces; i >= 0; --i) profile.emplace_back(profile[static_cast<std::size_t>(i)].x(), 0.0);
  for (std::size_t i = pieces + 1; i < profile.size(); ++i) {
    profile[i].y() = length - profile[profile.size() - 1 - i].y();
  }
  return lathe(profile, 16);
}

/// A sine wave in a cloth.
struct Fold {
  double along_x, along_y, phase, height;

  [[nodiscard]] double at(double x, double y) const {
    return height * std::sin(along_x * x + along_y * y + phase);
  }
};

std::vector<Fold> random_folds(Random& random, int count, double height) {
  std::vector<Fold> folds;
  for (int i = 0; i < count; ++i) {
    const double heading = random.uniform(0, 2 * pi);
    const double per_mm = 2 * pi / random.uniform(30, 110);
    folds.push_back({per_mm * std::cos(heading), per_mm * std::sin(heading), random.uniform(0, 2 * pi),
                     height * random.uniform(0.5, 1.0)});
  }
  return folds;
}

double height_of(const std::vector<Fold>& folds, double x, double y) {
  double height = 0.0;
  for (const Fold& fold : folds) height += fold.at(x, y);
  return height;
}

}  // namespace

// A drill throws off a flat chip that coils; its radius grows as the lip heats up.
Parts swarf(Random& random) {
  constexpr int per_turn = 16;
  const int steps = static_cast<int>(per_turn * random.uniform(3.0, 7.0));
  const double first_radius = random.uniform(2.0, 3.5);
  const double growth = random.uniform(-0.2, 0.25);
  const double pitch = random.uniform(2.6, 4.0);
  const double sway = random.uniform(0.0, 3.0);
  std::vector<Eigen::Vector3d> path;
  std::vector<Eigen::Vector3d> normals;
  for (int i = 0; i <= steps; ++i) {
    const double turns = static_cast<double>(i) / per_turn;
    const Eigen::Vector3d out(-std::cos(2 * pi * turns), std::sin(2 * pi * turns), 0);
    path.push_back((first_radius + growth * turns) * out +
                   Eigen::Vector3d(sway * std::sin(turns), 0.3 * sway * turns, pitch * turns));
    normals.push_back(-out);
  }
  return fitted({part_of("bare-aluminium", ribbon(path, normals, Eigen::Vector3d::UnitZ(), 1.8, 0.35))},
                25.0);
}

// Insulated wire, cut off and bent, nearly flat.
Parts wire(Random& random) {
  constexpr int steps = 48;
  const double first_bend = random.uniform(-0.06, 0.06);
  const double second_bend = random.uniform(-0.10, 0.10);
  const double wave = random.uniform(0.15, 0.35);
  std::vector<Eigen::Vector3d> path;
  Eigen::Vector2d point(0, 0);
  double heading = 0.0;
  for (int i = 0; i <= steps; ++i) {
    path.emplace_back(point.x(), point.y(), 0.5 * std::sin(wave * i));
    heading += i < steps / 2 ? first_bend : second_bend;
    point += 2.0 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  }
  return fitted({part_of("red-plastic", rod(path, 0.9, 8))}, 80.0);
}

Parts tape_roll() {
  const TriangleMesh core = turned_hollow({{38, 0}, {39.6, 0}, {39.6, 25}, {38, 25}}, 48);
  const TriangleMesh tape = turned_hollow({{39.5, 0.2}, {47.5, 0.2}, {47.5, 24.8}, {39.5, 24.8}}, 48);
  return {part_of("paper", core), part_of("masking-tape", tape)};
}

Parts tape_strip(Random& random) {
  const double curl = random.uniform(0.02, 0.05);
  const double tightening = random.uniform(0.0005, 0.0015);
  const TriangleMesh strip = bent_strip(40, 1.8, 19.0, 0.3, [&](int i) { return curl + tightening * i; });
  return fitted({part_of("masking-tape", strip)}, 50.0);
}

// Folds rise above a plane in which the rest of the cloth lies; its edges are drawn in where
// it is crumpled.
Parts rag(Random& random) {
  constexpr int columns = 41;
  constexpr int rows = 31;
  constexpr double pitch = 5.0;
  const std::vector<Fold> folds = random_folds(random, 7, 9.0);
  const std::vector<Fold> drawn_x = random_folds(random, 4, 5.0);
  const std::vector<Fold> drawn_y = random_folds(random, 4, 5.0);
  std::vector<double> heights;
  for (int i = 0; i < columns * rows; ++i) {
    const int row = i / columns;
    const double height = height_of(folds, pitch * (i % columns), pitch * row);
    heights.push_back(std::max(0.0, height) + 0.02 * std::min(0.0, height));
  }
  TriangleMesh cloth = sheet(heights, columns, pitch, 1.2);
  for (Eigen::Vector3f& vertex : cloth.vertices) {
    const Eigen::Vector2d flat = vertex.head<2>().cast<double>();
    // The waves are long and low enough that neighbours never swap, which would turn the cloth inside out.
    vertex.x() += static_cast<float>(0.4 * height_of(drawn_x, flat.x() / 2, flat.y() / 2));
    vertex.y() += static_cast<float>(0.4 * height_of(drawn_y, flat.x() / 2, flat.y() / 2));
  }
  return fitted({part_of("fabric-red", cloth)}, 200.0);
}

// A palm, a cuff, four fingers and a thumb, all flattened like an empty glove.
Parts glove(Random& random) {
  TriangleMesh hand = scaled(capsule(0.5, 0.7), {92, 30, 78});
  hand.append(moved(scaled(capsule(0.5, 0.6), {84, 26, 60}), {0, 0, -35}));
  constexpr std::array<double, 4> lengths{62, 74, 70, 54};
  for (int finger = 0; finger < 4; ++finger) {
    const TriangleMesh straight =
        scaled(capsule(10.5, lengths[static_cast<std::size_t>(finger)]), {1, 0.7, 1});
    const double spread_deg = 6.0 * (finger - 1.5) + random.uniform(-4, 4);
    const TriangleMesh spread = turned(straight, spread_deg, Eigen::Vector3d::UnitY());
    const TriangleMesh bent = turned(spread, random.uniform(-14, 6), Eigen::Vector3d::UnitX());
    hand.append(moved(bent, {22.0 * (finger - 1.5), 0, 62}));
  }
  const double thumb_deg = random.uniform(-55, -30);
  const TriangleMesh thumb =
      turned(scaled(capsule(12, 58), {1, 0.7, 1}), thumb_deg, Eigen::Vector3d::UnitY());
  hand.append(moved(thumb, {-34, 0, 18}));
  return fitted({part_of("leather", hand)}, 225.0);
}

}  // namespace rva
