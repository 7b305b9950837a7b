#include "scene/wing/wing_bay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>

#include "scene/solids/shapes.hpp"
#include "scene/wing/rivets.hpp"
#include "scene/wing/stringers.hpp"

namespace rva {
namespace {

constexpr double rib_flange_m = 0.025;
constexpr double room_half_width_m = 4.0;
constexpr double room_floor_z_m = -0.8;
constexpr double room_ceiling_z_m = 2.4;
constexpr double room_wall_thickness_m = 0.1;

TriangleMesh box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return transformed(box(high - low), Transform(Eigen::Translation3d((low + high) / 2)));
}

SceneObject object(std::string name, std::string kind, TriangleMesh mesh, const std::string& material) {
  SceneObject made;
  made.name = std::move(name);
  made.kind = std::move(kind);
  made.parts.push_back({std::move(mesh), find_material(material)});
  return made;
}

SceneObject room(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                 const std::string& material) {
  SceneObject made = object(name, name, box_between(low, high), material);
  made.role = Role::room;
  return made;
}

// The bay's dimensions and the thicknesses of its sheets, in metres.
struct Sizes {
  explicit Sizes(const WingBay& bay)
      : half_span(bay.span_m / 2),
        chord(bay.chord_m),
        height(bay.height_m),
        skin(bay.skin_mm * 1e-3),
        rib(bay.ribs.thickness_mm * 1e-3),
        spar(bay.spars.thickness_mm * 1e-3),
        cap(bay.spars.flange_mm * 1e-3) {}
  double half_span;
  double chord;
  double height;
  double skin;
  double rib;
  double spar;
  double cap;
};

SceneObject skin(const std::string& name, const WingBay& bay, double low_z_m) {
  const Sizes sizes(bay);
  const double half_width = sizes.half_span + sizes.rib;
  return object(name, "skin",
                box_between({-half_width, -sizes.spar, low_z_m},
                            {half_width, sizes.chord + sizes.spar, low_z_m + sizes.skin}),
                bay.skin_material);
}

std::vector<RoundHole> lightening_holes(const WingBay& bay) {
  const double radius = bay.ribs.hole_diameter_mm * 1e-3 / 2;
  std::vector<RoundHole> holes;
  for (int k = 0; k < bay.ribs.holes; ++k)
    holes.push_back({{bay.chord_m * ((k + 0.5) / bay.ribs.holes - 0.5), 0.0}, radius, radius});
  return holes;
}

// A web with holes and a flange along either skin.
// @param side -1: left, 1: right
SceneObject rib(const std::string& name, const WingBay& bay, double side) {
  const Sizes sizes(bay);
  Transform upright = Transform::Identity();
  upright.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // the plate's x and y become y and z
  upright.translation() =
      Eigen::Vector3d(side * (sizes.half_span + sizes.rib / 2), sizes.chord / 2, sizes.height / 2);
  TriangleMesh mesh =
      transformed(plate({sizes.chord, sizes.height, sizes.rib}, lightening_holes(bay)), upright);

  const double face = side * sizes.half_span;
  const double edge = face - side * rib_flange_m;
  const auto flange = [&](double low_z) {
    return box_between({std::min(face, edge), 0, low_z},
                       {std::max(face, edge), sizes.chord, low_z + sizes.rib});
  };
  mesh.append(flange(0));
  mesh.append(flange(sizes.height - sizes.rib));
  const double middle = (face + edge) / 2;
  mesh.append(rivet_row({middle, 0, sizes.rib}, {middle, sizes.chord, sizes.rib}));
  return object(name, "rib", std::move(mesh), bay.rib_material);
}

// Flanges along the skins, on the bay's side of a spar.
// @param low_y their lower limit in y
TriangleMesh spar_caps(const Sizes& sizes, double low_y, double top_z) {
  const Eigen::Vector3d size(2 * sizes.half_span, sizes.cap, sizes.spar);
  const Eigen::Vector3d lower(-sizes.half_span, low_y, 0);
  const Eigen::Vector3d upper(-sizes.half_span, low_y, top_z - sizes.spar);
  TriangleMesh mesh = box_between(lower, lower + size);
  mesh.append(box_between(upper, upper + size));
  const double middle_y = low_y + sizes.cap / 2;
  mesh.append(rivet_row({-sizes.half_span, middle_y, sizes.spar}, {sizes.half_span, middle_y, sizes.spar}));
  return mesh;
}

SceneObject near_spar(const WingBay& bay) {
  const Sizes sizes(bay);
  std::vector<RoundHole> access;
  if (bay.access_hole_width_mm > 0 && bay.access_hole_height_mm > 0)
    access.push_back({{0, 0}, bay.access_hole_width_mm * 1e-3 / 2, bay.access_hole_height_mm * 1e-3 / 2});
  Transform upright(Eigen::Translation3d(0, -sizes.spar / 2, sizes.height / 2));
  upright.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()));
  TriangleMesh mesh =
      transformed(plate({2 * (sizes.half_span + sizes.rib), sizes.height, sizes.spar}, access), upright);
  mesh.append(spar_caps(sizes, 0, sizes.height));
  return object("spar-near", "spar", std::move(mesh), bay.spar_material);
}

SceneObject far_spar(const WingBay& bay) {
  const Sizes sizes(bay);
  const double half_width = sizes.half_span + sizes.rib;
  const double top = bay.spars.rear_height_mm * 1e-3;
  TriangleMesh mesh = box_between({-half_width, sizes.chord, 0}, {half_width, sizes.chord + sizes.spar, top});
  mesh.append(spar_caps(sizes, sizes.chord - sizes.cap, top));
  return object("spar-far", "spar", std::move(mesh), bay.spar_material);
}

void add_stringers(const WingBay& bay, std::vector<SceneObject>& objects) {
  if (bay.stringers.count == 0) return;
  const TriangleMesh mesh = stringer(bay.stringers, bay.span_m);
  for (int k = 1; k <= bay.stringers.count; ++k) {
    objects.push_back(object(fmt::format("stringer-{}", k), "stringer", mesh, bay.stringer_material));
    objects.back().world_from_object.translation().y() = bay.chord_m * k / (bay.stringers.count + 1);
  }
}

void add_room(const WingBay& bay, std::vector<SceneObject>& objects) {
  const double far = std::max(bay.back_wall_m, bay.chord_m + 1.0);
  const double below = room_floor_z_m - room_wall_thickness_m;
  objects.push_back(
      room("floor", {-room_half_width_m, -1.0, below}, {room_half_width_m, far, room_floor_z_m}, "concrete"));
  if (bay.back_wall_m <= 0) return;
  objects.push_back(room("back-wall", {-room_half_width_m, bay.back_wall_m, below},
                         {room_half_width_m, bay.back_wall_m + room_wall_thickness_m, room_ceiling_z_m},
                         "plaster"));
}

}  // namespace

std::vector<SceneObject> build_wing_bay(const WingBay& bay) {
  std::vector<SceneObject> objects;
  objects.push_back(skin("skin-lower", bay, -bay.skin_mm * 1e-3));
  if (bay.upper_skin) objects.push_back(skin("skin-upper", bay, bay.height_m));
  add_stringers(bay, objects);
  objects.push_back(rib("rib-left", bay, -1.0));
  objects.push_back(rib("rib-right", bay, 1.0));
  objects.push_back(near_spar(bay));
  objects.push_back(far_spar(bay));
  std::ranges::move(make_fittings(bay, bay.fittings, Role::structure), std::back_inserter(objects));
  for (SceneObject& made : objects) {
    for (Part& part : made.parts) part.material.dirt = bay.dirt;
  }
  add_room(bay, objects);
  return objects;
}

Eigen::AlignedBox3d inside_of(const WingBay& bay) {
  return {Eigen::Vector3d(-bay.span_m / 2, 0, 0), Eigen::Vector3d(bay.span_m / 2, bay.chord_m, bay.height_m)};
}

}  // namespace rva
