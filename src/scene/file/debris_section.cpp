#include "scene/file/debris_section.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "core/interrupt.hpp"
#include "core/path_text.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/debris/lying_direction.hpp"
#include "scene/debris/random_debris.hpp"
#include "scene/debris/resting.hpp"
#include "scene/drop_zone.hpp"
#include "scene/file/object_fields.hpp"

namespace rva {
namespace {

std::vector<std::string_view> kind_names() {
  std::vector<std::string_view> names;
  for (const DebrisKind& kind : debris_catalogue()) names.push_back(kind.name);
  return names;
}

std::string read_kind(const YamlNode& value) {
  const std::vector<std::string_view> names = kind_names();
  return std::string(names[value.choice("kind of debris", names)]);
}

Transform read_drop(const YamlNode& item, const SceneObject& object, const Scene& scene) {
  const Eigen::Vector2d on = read_pair(item.at("on"), place_range_m);
  double from_m = default_look_down_m(scene);
  item.read("from_m", from_m, place_range_m);
  double turn_deg = 0;
  item.read("turn_deg", turn_deg, {-360, 360});

  const std::vector<RestingOrientation> orientations = resting_orientations(object.parts);
  int resting = 0;
  item.read("resting", resting, 0, static_cast<int>(orientations.size()) - 1);
  const RestingOrientation& orientation = orientations[static_cast<std::size_t>(resting)];
  turn_deg -= lying_direction_deg(object.parts, orientation);
  const auto pose = put_down(RayCaster(scene), object.parts, orientation, turn_deg, {on.x(), on.y(), from_m});
  if (!pose)
    throw item.at("on").error(fmt::format("{} does not come to rest there", object.kind),
                              "choose another position, turn_deg, resting or from_m");
  return *pose;
}

void add_by_hand(const YamlNode& item, Role role, Scene& scene) {
  if (item.has("at_m"))
    item.allow_only({"kind", "name", "shape_seed", "at_m", "turn_deg"});
  else
    item.allow_only({"kind", "name", "shape_seed", "on", "from_m", "resting", "turn_deg"});

  SceneObject object;
  object.role = role;
  object.kind = read_kind(item.at("kind"));
  if (const auto name = item.find("name")) {
    object.name = name->text();
    require_new_name(scene, object.name, *name);
  }
  const auto shape_seed = item.find("shape_seed");
  object.parts = make_debris(object.kind, shape_seed ? shape_seed->seed() : 1);
  object.world_from_object = item.has("at_m") ? read_pose(item) : read_drop(item, object, scene);
  if (!lies_inside(scene, object))
    throw item.at(item.has("at_m") ? "at_m" : "on")
        .error(fmt::format("{} lies outside the bay", object.kind), "choose a position inside it");
  scene.objects.push_back(std::move(object));
}

std::vector<std::string> read_kinds(const YamlNode& item) {
  std::vector<std::string> kinds;
  if (const auto list = item.find("kinds")) {
    for (const YamlNode& kind : list->items()) kinds.push_back(read_kind(kind));
    if (kinds.empty()) throw list->error("lists no kind", "list some, or omit the key for all kinds");
    return kinds;
  }
  for (const std::string_view kind : kind_names()) kinds.emplace_back(kind);
  return kinds;
}

Eigen::AlignedBox2d read_bounds(const YamlNode& item, const Scene& scene) {
  const auto list = item.find("within_m");
  if (!list && scene.bay.isEmpty())
    throw item.error("key \"within_m\" is missing where there is no wing", "add it");
  if (!list) return {scene.bay.min().head<2>(), scene.bay.max().head<2>()};
  const std::vector<YamlNode> corners = list->items();
  if (corners.size() != 2) throw list->error("not two corners", "write [[x0, y0], [x1, y1]]");
  Eigen::AlignedBox2d within;
  for (const YamlNode& corner : corners) within.extend(read_pair(corner, place_range_m));
  return within;
}

void add_at_random(const YamlNode& item, std::uint64_t group, std::optional<std::uint64_t> seed,
                   Scene& scene) {
  item.allow_only({"random", "kinds", "seed", "within_m", "from_m"});
  RandomDebris wanted;
  wanted.count = item.at("random").integer(1, 1000);
  wanted.kinds = read_kinds(item);
  if (const auto own_seed = item.find("seed")) wanted.seed = own_seed->seed();
  wanted.seed = seed.value_or(wanted.seed);
  wanted.group = group;
  wanted.within = read_bounds(item, scene);
  wanted.from_m = default_look_down_m(scene);
  item.read("from_m", wanted.from_m, place_range_m);

  const int placed = place_at_random(wanted, scene);
  if (placed < wanted.count)
    throw item.at("random").error(fmt::format("found room for only {} of {}", placed, wanted.count),
                                  "ask for fewer pieces or smaller kinds, or widen within_m");
}

// Names the objects that have no name: "collar-0.27" if it is the only one of its kind without a name, else
// "collar-0.27-1", "collar-0.27-2" ...
void name_the_rest(Scene& scene) {
  std::map<std::string, int> unnamed;
  std::set<std::string> taken;
  for (const SceneObject& object : scene.objects) {
    if (object.name.empty()) ++unnamed[object.kind];
    taken.insert(object.name);
  }
  std::map<std::string, int> last;
  for (SceneObject& object : scene.objects) {
    if (!object.name.empty()) continue;
    if (unnamed[object.kind] == 1) object.name = object.kind;
    while (!taken.insert(object.name).second || object.name.empty())
      object.name = fmt::format("{}-{}", object.kind, ++last[object.kind]);
  }
}

}  // namespace

void add_debris(const YamlNode& section, std::optional<std::uint64_t> seed, Scene& scene) {
  std::uint64_t group = 0;
  for (const YamlNode& item : section.items()) {
    throw_if_interrupted();
    if (item.has("random"))
      add_at_random(item, group++, seed, scene);
    else
      add_by_hand(item, Role::debris, scene);
  }
  name_the_rest(scene);
}

void add_planned_parts(const YamlNode& section, Scene& scene) {
  for (const YamlNode& item : section.items()) {
    throw_if_interrupted();
    add_by_hand(item, Role::work, scene);
  }
  name_the_rest(scene);
}

}  // namespace rva
