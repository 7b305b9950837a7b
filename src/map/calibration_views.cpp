#include "map/calibration_views.hpp"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

void require_same_robot(const CaptureInfo& first, const CaptureInfo& info, const std::string& name) {
  const auto base = [](const CaptureInfo& of) { return of.pose ? of.pose->base : std::nullopt; };
  const auto device = [](const CaptureInfo& of) { return of.camera.value_or(CameraInfo{}); };
  if (!base(info))
    throw Error(name, "does not state where it was taken (pose.base)", "give captures of one map");
  if (base(info) != base(first))
    throw Error(name, "was not taken from the same position as the others (pose.base)",
                "give captures of one map");
  if (info.depth != first.depth || device(info).serial != device(first).serial ||
      device(info).baseline_m != device(first).baseline_m)
    throw Error(name, "was not taken by the same camera as the others", "give captures of one map");
}

}  // namespace

std::vector<MapView> load_calibration_views(const std::vector<fs::path>& captures, const Progress& progress) {
  std::vector<MapView> views;
  std::optional<CaptureInfo> first;
  std::set<fs::path> seen;
  for (const fs::path& path : captures) {
    std::error_code ignored;
    if (!seen.insert(fs::weakly_canonical(path, ignored)).second)
      throw Error(printable(path), "is given twice", "give each view once");
    const std::unique_ptr<Capture> capture = open_capture(path);
    if (!first) first = capture->info();
    require_same_robot(*first, capture->info(), printable(path));
    views.push_back(load_map_view(*capture, printable(path)));
    if (progress) progress("reading", views.size(), captures.size());
  }
  return views;
}

}  // namespace rva
