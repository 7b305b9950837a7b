#include "geometry/robot_geometry_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr double tolerance = 1e-3;

Eigen::Vector3d vector(const JsonObject& object, const char* key) {
  const std::vector<double> numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Vector3d position(const JsonObject& object) {
  constexpr double most_m = 2.0;
  Eigen::Vector3d at_m = vector(object, "at_m");
  if (at_m.norm() <= most_m) return at_m;
  throw Error(object.name_of("at_m"),
              fmt::format("lies {:.3g} m from the part that carries it, more than {} m", at_m.norm(), most_m),
              "give metres");
}

Eigen::Vector3d unit_vector(const JsonObject& object, const char* key) {
  const Eigen::Vector3d direction = vector(object, key);
  if (std::abs(direction.norm() - 1.0) <= tolerance) return direction.normalized();
  throw Error(object.name_of(key), fmt::format("has length {:.6g} instead of 1", direction.norm()),
              "divide its numbers by its length");
}

// Positive angles turn the same way on every robot (pan_tilt.hpp), so that limits and waypoints apply to all.
JointAxis joint(const JsonObject& object, const Eigen::Vector3d& towards, const char* meaning) {
  JointAxis joint{position(object), unit_vector(object, "axis")};
  if (joint.axis.dot(towards) > 0.5) return joint;
  throw Error(object.name_of("axis"), fmt::format("does not point {}", meaning),
              "turn the axis around, and the sign of this servo's angles with it");
}

Transform camera(const JsonObject& object) {
  Transform bracket_from_camera = Transform::Identity();
  bracket_from_camera.linear() << unit_vector(object, "right"), unit_vector(object, "down"),
      unit_vector(object, "forward");
  const Eigen::Matrix3d axes = bracket_from_camera.linear();
  if (!(axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity(), 2.0 * tolerance))
    throw Error(object.name_of("right, down, forward"), "the camera's axes are not at right angles",
                "give three axes at right angles to each other");
  if (axes.determinant() < 0.0)
    throw Error(object.name_of("right, down, forward"), "the camera's axes are left-handed",
                "turn one of them around: right x down must be forward");
  bracket_from_camera.linear() = Eigen::Quaterniond(axes).normalized().toRotationMatrix();
  bracket_from_camera.translation() = position(object);
  return bracket_from_camera;
}

Json numbers(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

PanTiltChain load_robot_geometry(const std::filesystem::path& path) {
  const std::string file = printable(path);
  const nlohmann::json json = parse_json(read_text_file(path), file);
  const JsonObject object(json, file);
  if (object.optional_string("format") != "rva-robot-geometry")
    throw Error(file, "is not a robot geometry", "give a file that rva calibrate has written");
  if (object.integer("version") != 1)
    throw Error(object.name_of("version"), "is not 1, the only supported version", "use a newer rva");
  return {
      joint(object.object("servo1"), Eigen::Vector3d::UnitZ(), "up, so that positive pan would not be left"),
      joint(object.object("bracket"), Eigen::Vector3d::UnitX(),
            "to the right, so that positive tilt would not be up"),
      camera(object.object("camera"))};
}

Json json_of(const PanTiltChain& chain) {
  const Eigen::Matrix3d axes = chain.bracket_from_camera.linear();
  return {{"format", "rva-robot-geometry"},
          {"version", 1},
          {"servo1", {{"at_m", numbers(chain.servo1.at_m)}, {"axis", numbers(chain.servo1.axis)}}},
          {"bracket", {{"at_m", numbers(chain.bracket.at_m)}, {"axis", numbers(chain.bracket.axis)}}},
          {"camera",
           {{"at_m", numbers(chain.bracket_from_camera.translation())},
            {"right", numbers(axes.col(0))},
            {"down", numbers(axes.col(1))},
            {"forward", numbers(axes.col(2))}}}};
}

void require_replaceable_geometry(const std::filesystem::path& path, bool overwrite) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  if (!overwrite) throw ExistsError(printable(path), "already exists", "choose another name, or replace it");
  try {
    if (std::filesystem::is_regular_file(status)) {
      static_cast<void>(load_robot_geometry(path));
      return;
    }
  } catch (const Error&) {  // reported below
  }
  throw Error(printable(path), "is not a robot's geometry, so it is not replaced", "choose another name");
}

}  // namespace rva
