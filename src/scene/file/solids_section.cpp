#include "scene/file/solids_section.hpp"

#include <array>

#include "core/path_text.hpp"
#include "scene/file/object_fields.hpp"
#include "scene/solids/mesh_file.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

constexpr NumberRange size_range_mm{0.01, 100000.0};
constexpr double plane_thickness_m = 0.001;
constexpr int round_segments = 64;

TriangleMesh read_box(const YamlNode& solid) {
  solid.allow_only({"name", "shape", "size_mm", "at_m", "turn_deg", "material", "debris"});
  return box(read_vector(solid.at("size_mm"), size_range_mm) * 1e-3);
}

TriangleMesh read_cylinder(const YamlNode& solid) {
  solid.allow_only({"name", "shape", "diameter_mm", "length_mm", "at_m", "turn_deg", "material", "debris"});
  const double diameter_m = solid.at("diameter_mm").number(size_range_mm) * 1e-3;
  return cylinder(diameter_m / 2, solid.at("length_mm").number(size_range_mm) * 1e-3, round_segments);
}

// A sheet whose upper side passes through `at_m`.
TriangleMesh read_plane(const YamlNode& solid) {
  solid.allow_only({"name", "shape", "size_mm", "at_m", "turn_deg", "material", "debris"});
  const Eigen::Vector2d size_m = read_pair(solid.at("size_mm"), size_range_mm) * 1e-3;
  return transformed(box({size_m.x(), size_m.y(), plane_thickness_m}),
                     Transform(Eigen::Translation3d(0, 0, -plane_thickness_m / 2)));
}

struct Shape {
  std::string_view name;
  TriangleMesh (*read)(const YamlNode&);
};
constexpr std::array<Shape, 3> shapes{
    {{"box", read_box}, {"cylinder", read_cylinder}, {"plane", read_plane}}};
constexpr std::array<std::string_view, 3> shape_names{shapes[0].name, shapes[1].name, shapes[2].name};

void add_object(const YamlNode& entry, std::string kind, TriangleMesh mesh, Scene& scene) {
  SceneObject object;
  object.name = entry.at("name").text();
  require_new_name(scene, object.name, entry.at("name"));
  object.kind = std::move(kind);
  object.role = read_role(entry);
  object.world_from_object = read_pose(entry);
  object.parts.push_back({std::move(mesh), read_material(entry)});
  scene.objects.push_back(std::move(object));
}

TriangleMesh read_mesh(const YamlNode& entry, const std::filesystem::path& folder) {
  struct Unit {
    std::string_view name;
    double length_m;
  };
  constexpr std::array<Unit, 3> units{{{"mm", 1e-3}, {"m", 1.0}, {"in", 0.0254}}};
  constexpr std::array<std::string_view, 3> names{units[0].name, units[1].name, units[2].name};
  const Unit& unit = units[entry.at("unit").choice("unit", names)];

  const YamlNode file = entry.at("file");
  try {
    return load_mesh(folder / file.text(), unit.length_m);
  } catch (const Error& error) {
    throw file.error(error.source() + " " + error.problem(), error.remedy());
  }
}

}  // namespace

void add_solids(const YamlNode& section, Scene& scene) {
  for (const YamlNode& solid : section.items()) {
    const Shape& shape = shapes[solid.at("shape").choice("shape", shape_names)];
    add_object(solid, std::string(shape.name), shape.read(solid), scene);
  }
}

void add_meshes(const YamlNode& section, const std::filesystem::path& folder, Scene& scene) {
  for (const YamlNode& entry : section.items()) {
    entry.allow_only({"name", "file", "unit", "at_m", "turn_deg", "material", "debris"});
    add_object(entry, "mesh", read_mesh(entry, folder), scene);
  }
}

}  // namespace rva
