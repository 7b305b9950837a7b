#include "scene/wing/fittings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "core/random.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/solids/shapes.hpp"
#include "scene/traces.hpp"
#include "scene/wing/rivets.hpp"
#include "scene/wing/stringers.hpp"
#include "scene/wing/wing_bay.hpp"

namespace rva {
namespace {

constexpr double pi = std::numbers::pi;

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& by_m) {
  return transformed(mesh, Transform(Eigen::Translation3d(by_m)));
}

double stringer_y_m(const WingBay& bay, int number) {
  return bay.chord_m * number / (bay.stringers.count + 1);
}

// Between two neighbouring stringers, or, with fewer than two stringers, near the middle of the chord.
double gap_y_m(const WingBay& bay, Random& random) {
  const int gaps = bay.stringers.count - 1;
  if (gaps < 1) return random.uniform(0.4, 0.7) * bay.chord_m;
  const int left = 1 + static_cast<int>(random.bits() % static_cast<std::uint64_t>(gaps));
  return (stringer_y_m(bay, left) + stringer_y_m(bay, left + 1)) / 2;
}

double somewhere_x_m(const WingBay& bay, Random& random) {
  constexpr double from_rib = 0.4;  // share of the span to either side of the middle
  return random.uniform(-from_rib, from_rib) * bay.span_m;
}

double stringer_top_m(const WingBay& bay) {
  return bay.stringers.count > 0 ? bay.stringers.height_mm * 1e-3 : 0.0;
}

Part part(std::string_view material, TriangleMesh mesh) { return {std::move(mesh), find_material(material)}; }

// A foot on the skin and a leg that stands up from its edge.
std::vector<Part> bracket(const WingBay& bay, Random& random) {
  constexpr double sheet_m = 0.002;
  const double length_m = random.uniform(0.03, 0.07);
  const double foot_m = random.uniform(0.020, 0.030);
  const double height_m = random.uniform(0.020, 0.045);
  TriangleMesh mesh = moved(box({length_m, foot_m, sheet_m}), {0, 0, sheet_m / 2});
  mesh.append(moved(box({length_m, sheet_m, height_m}), {0, (sheet_m - foot_m) / 2, height_m / 2}));
  mesh.append(rivet_row({-length_m / 2, 0, sheet_m}, {length_m / 2, 0, sheet_m}));
  const double quarter_turns = static_cast<double>(random.bits() % 4U);
  Transform pose(Eigen::Translation3d(somewhere_x_m(bay, random), gap_y_m(bay, random), 0));
  pose.rotate(Eigen::AngleAxisd(quarter_turns * pi / 2, Eigen::Vector3d::UnitZ()));
  return {part(bay.rib_material, transformed(mesh, pose))};
}

std::vector<Part> hose(const WingBay& bay, Random& random) {
  constexpr int pieces = 30;
  constexpr double clamp_m = 0.012;
  constexpr double strap_m = 0.002;
  const double radius_m = random.uniform(0.006, 0.011);
  const double y_m = gap_y_m(bay, random);
  const double z_m = std::min(stringer_top_m(bay) + radius_m + random.uniform(0.01, 0.05), bay.height_m / 2);
  const double sag_m = random.uniform(0.002, 0.010);
  const double wander_m = random.uniform(0.0, 0.010);
  const double phase = random.uniform(0.0, 2 * pi);
  const auto at = [&](double share) {
    return Eigen::Vector3d((share - 0.5) * bay.span_m, y_m + wander_m * std::sin(2 * pi * share + phase),
                           z_m - sag_m * std::pow(std::sin(3 * pi * share), 2));
  };
  std::vector<Eigen::Vector3d> path;
  for (int i = 0; i <= pieces; ++i) path.push_back(at(static_cast<double>(i) / pieces));
  std::vector<Part> parts{part("black-rubber", rod(path, radius_m, 16))};
  TriangleMesh clamps;
  for (const double share : {1.0 / 3, 2.0 / 3}) {
    const Eigen::Vector3d middle = at(share);
    Transform along_x(Eigen::Translation3d{middle});
    along_x.rotate(Eigen::AngleAxisd(pi / 2, Eigen::Vector3d::UnitY()));
    clamps.append(transformed(tube(radius_m + strap_m, radius_m, clamp_m, 24), along_x));
    const double foot_z_m = middle.z() - radius_m;
    clamps.append(moved(box({clamp_m, strap_m, foot_z_m}), {middle.x(), middle.y(), foot_z_m / 2}));
  }
  parts.push_back(part("anodised-aluminium", std::move(clamps)));
  return parts;
}

// @param hanging random stream of the shape between the points of support
std::vector<Part> cable(const WingBay& bay, Random& random, Random hanging) {
  constexpr int pieces = 60;
  constexpr std::array<std::string_view, 3> jackets{"white-plastic", "blue-plastic", "black-plastic"};
  const double radius_m = random.uniform(0.002, 0.004);
  const double x_m = somewhere_x_m(bay, random) * 0.8;
  const std::string_view jacket = jackets.at(random.bits() % jackets.size());
  const double top_m = stringer_top_m(bay);
  const double sag_m = hanging.uniform(0.2, 0.7) * top_m;
  const double wander_m = hanging.uniform(0.004, 0.020);
  const double phase = hanging.uniform(0.0, 2 * pi);
  const double waves = hanging.uniform(1.0, 3.0);
  const int held = bay.stringers.count + 1;
  std::vector<Eigen::Vector3d> path;
  for (int i = 0; i <= pieces; ++i) {
    const double share = 0.25 + 0.72 * i / pieces;  // of the chord; avoids the position of the robot
    const double between = std::pow(std::sin(pi * share * held), 4);
    path.emplace_back(x_m + wander_m * std::sin(2 * pi * waves * share + phase), share * bay.chord_m,
                      radius_m + top_m - sag_m * between);
  }
  return {part(jacket, rod(path, radius_m, 12))};
}

std::vector<Part> sealant(const WingBay& bay, Random& random) {
  constexpr int pieces = 24;
  const double radius_m = random.uniform(0.003, 0.005);
  const double half_span_m = bay.span_m / 2;
  const double half_m = random.uniform(0.05, 0.17);
  const double middle_x_m = somewhere_x_m(bay, random);
  const double from_x_m = std::max(middle_x_m - half_m, -half_span_m);
  const double to_x_m = std::min(middle_x_m + half_m, half_span_m);
  const int stringers = std::max(1, bay.stringers.count);
  const int number = 1 + static_cast<int>(random.bits() % static_cast<std::uint64_t>(stringers));
  const double foot_y_m = stringer_y_m(bay, number) - bay.stringers.flange_mm * 1e-3;
  std::vector<Eigen::Vector3d> path;
  for (int i = 0; i <= pieces; ++i) {
    path.emplace_back(from_x_m + (to_x_m - from_x_m) * i / pieces, foot_y_m + random.uniform(-0.0008, 0.0008),
                      random.uniform(-0.0006, 0.0004));
  }
  return {part("sealant", rod(path, radius_m, 12))};
}

std::vector<Part> collars(const WingBay& bay, Random& random) {
  constexpr int in_a_row = 6;
  constexpr double pitch_m = 0.025;
  const double y_m = gap_y_m(bay, random);
  const double middle_x_m = 0.7 * somewhere_x_m(bay, random);
  const std::vector<Part> one = make_debris("collar-0.36", 1);
  Eigen::AlignedBox3d extent;
  for (const Part& piece : one) extent.extend(bounds(piece.mesh));
  std::vector<Part> row;
  for (int i = 0; i < in_a_row; ++i) {
    const Eigen::Vector3d foot(middle_x_m + (i - (in_a_row - 1) / 2.0) * pitch_m, y_m, -extent.min().z());
    for (const Part& piece : one) row.push_back({moved(piece.mesh, foot), piece.material});
  }
  return row;
}

/// Collects the fittings of one bay, all from one seed.
class Installer {
 public:
  Installer(const WingBay& bay, std::uint64_t seed, Role role, std::string_view prefix)
      : bay_(bay), seed_(seed), role_(role), prefix_(prefix) {}

  template <typename Make>
  void add(std::string_view kind, int count, Make make) {
    for (int i = 1; i <= count; ++i) add_one(kind, i, make);
  }
  template <typename Make>
  void add_one(std::string_view kind, int number, Make make) {
    Random random(mix(seed_, kind.size(), kind.front(), number));
    SceneObject object;
    object.name = fmt::format("{}{}-{}", prefix_, kind, number);
    object.kind = kind;
    object.role = role_;
    object.parts = make(bay_, random);
    objects_.push_back(std::move(object));
  }
  // Adds a cable whose shape depends on `hanging`, but whose points of support do not.
  void add_cable(int number, std::uint64_t hanging) {
    const Random shape(mix(seed_, number, hanging, 0xCAB1E));
    add_one("cable", number,
            [shape](const WingBay& bay, Random& random) { return cable(bay, random, shape); });
  }
  [[nodiscard]] std::vector<SceneObject> take() { return std::move(objects_); }

 private:
  const WingBay& bay_;
  std::uint64_t seed_;
  Role role_;
  std::string_view prefix_;
  std::vector<SceneObject> objects_;
};

}  // namespace

std::vector<SceneObject> make_fittings(const WingBay& bay, const Fittings& fittings, Role role,
                                       std::string_view name_prefix) {
  Installer installer(bay, fittings.seed, role, name_prefix);
  installer.add("bracket", fittings.brackets, bracket);
  installer.add("hose", fittings.hoses, hose);
  for (int number = 1; number <= fittings.cables; ++number) installer.add_cable(number, 0);
  installer.add("sealant", fittings.sealant, sealant);
  installer.add("collars", fittings.collars, collars);
  return installer.take();
}

void do_work(const WingBay& bay, const Work& work, Scene& scene) {
  Installer rehung(bay, bay.fittings.seed, Role::work, "rehung-");
  for (int number = 1; number <= std::min(work.rehung, bay.fittings.cables); ++number) {
    std::erase_if(scene.objects, [name = fmt::format("cable-{}", number)](const SceneObject& object) {
      return object.name == name;
    });
    rehung.add_cable(number, 1);
  }
  std::ranges::move(rehung.take(), std::back_inserter(scene.objects));
  std::ranges::move(make_fittings(bay, work.installed, Role::work, "new-"),
                    std::back_inserter(scene.objects));
  leave_traces(work.traces, scene);
}

}  // namespace rva
