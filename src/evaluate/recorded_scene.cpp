#include "evaluate/recorded_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* truth_file = "truth.json";

std::vector<fs::path> captures_of(const fs::path& folder, const std::string& side) {
  std::error_code ignored;
  std::vector<fs::path> captures;
  if (fs::is_directory(folder / side, ignored)) return {folder / side};
  for (int k = 0; fs::is_directory(folder / fmt::format("{}{}", side, k), ignored); ++k)
    captures.push_back(folder / fmt::format("{}{}", side, k));
  if (captures.empty())
    throw Error(printable(folder), fmt::format("has no capture {0} or {0}0", side),
                "see docs/evaluation.md for the contents of a recorded scene");
  return captures;
}

std::optional<Transform> transform_in(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  std::istringstream text(read_text_file(file));
  Transform transform;
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) text >> transform.matrix()(row, column);
  }
  constexpr double tolerance = 1e-3;
  const bool rigid = text && transform.matrix().allFinite() &&
                     (transform.linear() * transform.linear().transpose()).isIdentity(tolerance) &&
                     transform.linear().determinant() > 0.0;
  if (!rigid)
    throw Error(printable(file), "is not a rigid transform of 4x4 numbers",
                "give final_from_initial, row by row, in metres");
  return transform;
}

std::vector<RecordedTarget> targets_in(const fs::path& folder, const GrayImage& labels,
                                       const GrayImage& seen) {
  const std::string source = printable(folder / truth_file);
  const nlohmann::json document = parse_json(read_text_file(folder / truth_file), source);
  const JsonObject objects = JsonObject(document, source).object("objects");
  std::vector<RecordedTarget> targets;
  for (const std::string& number : objects.keys()) {
    const JsonObject object = objects.object(number.c_str());
    RecordedTarget target;
    target.target.kind = object.string("name");
    target.target.distance_m = object.optional_number("depth_m").value_or(0.0);
    std::size_t free = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (std::to_string(labels[i]) != number) continue;
      target.target.pixels.push_back(static_cast<std::uint32_t>(i));
      free += seen[i] != 0 ? 1U : 0U;
    }
    target.target.visible_px = static_cast<int>(target.target.pixels.size());
    target.target.unhidden_px = target.target.visible_px;
    target.seen_free = 2 * free >= target.target.pixels.size();
    if (target.target.visible_px > 0) targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace

RecordedScene load_recorded_scene(const fs::path& folder) {
  RecordedScene scene;
  scene.name = printable(folder.filename());
  scene.initial = captures_of(folder, "initial");
  scene.final = captures_of(folder, "final");
  const GrayImage labels = read_gray(folder / "label.png");
  const GrayImage seen = read_gray(folder / "seen.png");
  const Intrinsics depth = open_capture(scene.final.front())->info().depth;
  for (const auto& [image, name] : {std::pair{&labels, "label.png"}, {&seen, "seen.png"}}) {
    if (image->width() != depth.width || image->height() != depth.height)
      throw Error(printable(folder / name),
                  fmt::format("has {}x{} pixels, but the first final depth image has {}x{}", image->width(),
                              image->height(), depth.width, depth.height),
                  "give the truth of that image");
  }
  scene.width = depth.width;
  scene.height = depth.height;
  scene.targets = targets_in(folder, labels, seen);
  scene.final_from_initial = transform_in(folder / "final_from_initial.txt");
  return scene;
}

std::vector<RecordedScene> load_recorded_scenes(const fs::path& folder) {
  std::error_code failure;
  if (fs::exists(folder / truth_file, failure)) return {load_recorded_scene(folder)};
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    if (fs::exists(entry.path() / truth_file, failure)) folders.push_back(entry.path());
  }
  if (folders.empty())
    throw Error(printable(folder), "contains no recorded scene (a folder with truth.json)",
                "see docs/evaluation.md for the contents of a recorded scene");
  std::ranges::sort(folders);
  std::vector<RecordedScene> scenes;
  for (const fs::path& one : folders) scenes.push_back(load_recorded_scene(one));
  return scenes;
}

Captures open_first(const std::vector<fs::path>& captures, std::size_t count) {
  Captures opened;
  for (std::size_t i = 0; i < count; ++i) opened.push_back(open_capture(captures.at(i)));
  return opened;
}

}  // namespace rva
