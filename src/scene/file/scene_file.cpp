#include "scene/file/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "core/path_text.hpp"
#include "scene/camera_stand.hpp"
#include "scene/file/debris_section.hpp"
#include "scene/file/object_fields.hpp"
#include "scene/file/solids_section.hpp"
#include "scene/file/wing_section.hpp"
#include "scene/ray_caster.hpp"

namespace rva {
namespace {

constexpr std::size_t most_bytes = 1U << 20U;

YamlNode parse_document(const std::string& text, const std::filesystem::path& source) {
  const std::string name = printable(source);
  if (text.size() > most_bytes) throw Error(name, "larger than 1 MB, so not a scene file", "check the path");
  if (!is_utf8(text)) throw Error(name, "not UTF-8 text", "check the path, or save it as UTF-8");
  YamlNode document = YamlNode::parse(text, name);
  document.allow_only({"format", "version", "wing", "work", "solids", "meshes", "light", "robot", "debris"});
  const YamlNode format = document.at("format");
  if (format.text() != "rva-scene") throw format.error("not \"rva-scene\"", "check the path");
  const YamlNode version = document.at("version");
  if (version.text() != "1") throw version.error("not 1", "use a file of version 1, or a newer RVA");
  return document;
}

void add_wing(const YamlNode& document, const SceneOverrides& overrides, Scene& scene) {
  const auto section = document.find("wing");
  const auto work = document.find("work");
  if (work && !section) throw work->error("work requires a wing, and the scene has none", "add a wing");
  if (!section) return;
  const WingBay bay = read_wing(*section);
  scene.objects = build_wing_bay(bay);
  scene.bay = inside_of(bay);
  if (!work) return;
  const Work done = read_work(*work);
  if (!overrides.no_debris) do_work(bay, done, scene);
}

void read_light(const YamlNode& section, Lighting& lighting) {
  constexpr std::size_t most_lamps = 16;
  section.allow_only({"ambient", "visible", "lamps"});
  section.read("ambient", lighting.ambient, {0.0, 100.0});
  section.read("visible", lighting.visible, {0.0, 1.0});
  const auto lamps = section.find("lamps");
  if (!lamps) return;
  for (const YamlNode& item : lamps->items()) {
    item.allow_only({"at_m", "strength"});
    Lamp lamp;
    lamp.position_m = read_vector(item.at("at_m"), place_range_m);
    item.read("strength", lamp.strength, {0.0, 1000.0});
    lighting.lamps.push_back(lamp);
  }
  if (lighting.lamps.size() > most_lamps) throw lamps->error(fmt::format("more than {} lamps", most_lamps));
}

void read_robot(const YamlNode& section, CameraStand& stand) {
  section.allow_only({"base", "at_m", "heading_deg", "pan_deg", "tilt_deg"});
  if (const auto base = section.find("base")) stand.base = base->text();
  if (const auto at = section.find("at_m")) stand.position_m = read_vector(*at, place_range_m);
  section.read("heading_deg", stand.heading_deg, {-360, 360});
  section.read("pan_deg", stand.pan_deg, {-180, 180});
  section.read("tilt_deg", stand.tilt_deg, {-90, 90});
}

void override_stand(const SceneOverrides& overrides, CameraStand& stand) {
  stand.position_m = overrides.position_m.value_or(stand.position_m);
  stand.pan_deg = overrides.pan_deg.value_or(stand.pan_deg);
  stand.tilt_deg = overrides.tilt_deg.value_or(stand.tilt_deg);
}

void read_planned_parts(const YamlNode& document, const SceneOverrides& overrides, Scene& scene) {
  const auto work = document.find("work");
  const auto parts = work ? work->find("parts") : std::nullopt;
  if (parts && !overrides.no_debris) add_planned_parts(*parts, scene);
}

void read_debris(const YamlNode& document, const SceneOverrides& overrides, Scene& scene) {
  if (overrides.no_debris) {
    std::erase_if(scene.objects, [](const SceneObject& object) { return object.role == Role::debris; });
    return;
  }
  if (overrides.debris_file) require_utf8(*overrides.debris_file);
  const std::optional<YamlNode> other =
      overrides.debris_file
          ? std::optional(parse_document(read_text_file(*overrides.debris_file), *overrides.debris_file))
          : std::nullopt;
  if (const auto section = (other ? *other : document).find("debris"))
    add_debris(*section, overrides.debris_seed, scene);
}

void require_free_camera(const YamlNode& document, const SceneOverrides& overrides, const Scene& scene) {
  const Eigen::Vector3d camera = world_from_camera(scene.stand).translation();
  const auto solid = RayCaster(scene).solid_around(camera);
  if (!solid) return;
  const std::string problem =
      fmt::format("the camera at {:.3f}, {:.3f}, {:.3f} m is inside \"{}\"", camera.x(), camera.y(),
                  camera.z(), printable(scene.objects[*solid].name));
  const std::string remedy = "move the robot elsewhere";
  if (overrides.position_m) throw Error("position", problem, remedy);
  throw document.find("robot").value_or(document).error(problem, remedy);
}

}  // namespace

Scene parse_scene(const std::string& text, const std::filesystem::path& source,
                  const SceneOverrides& overrides) {
  const YamlNode document = parse_document(text, source);
  Scene scene;
  scene.name = source.stem().string();
  add_wing(document, overrides, scene);
  if (const auto solids = document.find("solids")) add_solids(*solids, scene);
  if (const auto meshes = document.find("meshes")) add_meshes(*meshes, source.parent_path(), scene);
  if (const auto light = document.find("light")) read_light(*light, scene.lighting);
  if (const auto robot = document.find("robot")) read_robot(*robot, scene.stand);
  override_stand(overrides, scene.stand);
  read_planned_parts(document, overrides, scene);
  read_debris(document, overrides, scene);
  require_free_camera(document, overrides, scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
  require_utf8(file);  // its name becomes the scene's
  return parse_scene(read_text_file(file), file, overrides);
}

}  // namespace rva
