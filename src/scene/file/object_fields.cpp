#include "scene/file/object_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/path_text.hpp"

namespace rva {

Eigen::Vector3d read_vector(const YamlNode& value, NumberRange range) {
  const std::vector<double> numbers = value.numbers(3, range);
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Vector2d read_pair(const YamlNode& value, NumberRange range) {
  const std::vector<double> numbers = value.numbers(2, range);
  return {numbers[0], numbers[1]};
}

Transform read_pose(const YamlNode& object) {
  Transform pose(Eigen::Translation3d(read_vector(object.at("at_m"), place_range_m)));
  const auto turn = object.find("turn_deg");
  if (!turn) return pose;
  const Eigen::Vector3d angles = read_vector(*turn, {-360, 360}) * (std::numbers::pi / 180);
  pose.rotate(Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
              Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
              Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()));
  return pose;
}

const Material& read_material(const YamlNode& object) {
  const std::vector<std::string_view> names = material_names();
  return find_material(names[object.at("material").choice("material", names)]);
}

Role read_role(const YamlNode& object) {
  bool debris = false;
  object.read("debris", debris);
  return debris ? Role::debris : Role::structure;
}

void require_new_name(const Scene& scene, const std::string& name, const YamlNode& named) {
  const bool taken = std::any_of(scene.objects.begin(), scene.objects.end(),
                                 [&](const SceneObject& object) { return object.name == name; });
  if (taken)
    throw named.error(fmt::format("\"{}\" is already the name of another object", printable(name)),
                      "give each object a unique name");
}

}  // namespace rva
