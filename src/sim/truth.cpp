#include "sim/truth.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/units.hpp"
#include "depth/image_file.hpp"

namespace rva {

namespace {

using Json = nlohmann::ordered_json;

constexpr double unit_m = 0.0001;

/// The visible pixels of an object in the depth image: their number and bounding box, last pixel included.
struct Seen {
  int pixels = 0;
  int u0 = 0;
  int v0 = 0;
  int u1 = -1;
  int v1 = -1;

  void add(int u, int v) {
    if (pixels++ == 0) {
      *this = {.pixels = 1, .u0 = u, .v0 = v, .u1 = u, .v1 = v};
      return;
    }
    u0 = std::min(u0, u);
    v0 = std::min(v0, v);
    u1 = std::max(u1, u);
    v1 = std::max(v1, v);
  }
};

std::vector<Seen> find_seen(const LabelImage& labels, std::size_t objects) {
  std::vector<Seen> seen(objects + 1);
  for (int v = 0; v < labels.height(); ++v) {
    for (int u = 0; u < labels.width(); ++u) seen[labels(u, v)].add(u, v);
  }
  return seen;
}

Json json_of(const SceneObject& object, int label, const Seen& seen) {
  const Eigen::Vector3d size_mm = mm_per_m * size_m(object);
  Json json{{"label", label},
            {"name", object.name},
            {"kind", object.kind},
            {"role", name_of(object.role)},
            {"size_mm", {size_mm.x(), size_mm.y(), size_mm.z()}},
            {"world_from_object", to_row_major(object.world_from_object)},
            {"visible_px", seen.pixels}};
  if (seen.pixels > 0) json["bbox"] = {seen.u0, seen.v0, seen.u1 - seen.u0 + 1, seen.v1 - seen.v0 + 1};
  return json;
}

Json json_of(const SimulatedCamera& camera, const TrueView& view) {
  Json json{{"format", "rva-truth"},
            {"version", 1},
            {"scene", camera.scene().name},
            {"depth_unit_m", unit_m},
            {"world_from_camera", to_row_major(camera.world_from_camera())}};
  const auto& objects = camera.scene().objects;
  const std::vector<Seen> seen = find_seen(view.labels, objects.size());
  json["objects"] = Json::array();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const int label = Scene::label_of(i);
    json["objects"].push_back(json_of(objects[i], label, seen[static_cast<std::size_t>(label)]));
  }
  return json;
}

DepthImage to_units(const Image<float>& depth_m) {
  DepthImage depth(depth_m.width(), depth_m.height(), no_depth);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double units = std::round(static_cast<double>(depth_m[i]) / unit_m);
    if (units <= 65535.0) depth[i] = static_cast<std::uint16_t>(units);
  }
  return depth;
}

}  // namespace

void write_truth(const SimulatedCamera& camera, const OutputFolder& capture) {
  const TrueView view = camera.true_view();
  std::error_code ignored;  // if the folder cannot be made, writing the first file reports it
  std::filesystem::create_directory(capture.path("truth"), ignored);
  write_file(capture.path("truth") / "labels.png", encode_png(view.labels));
  write_file(capture.path("truth") / "depth.png", encode_png(to_units(view.depth_m)));
  write_file(capture.path("truth") / "truth.json", json_file_text(json_of(camera, view)));
}

}  // namespace rva
