#include "inspect/baseline_check.hpp"

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "depth/image_file.hpp"
#include "detect/detect.hpp"
#include "detect/findings/drawing.hpp"
#include "detect/result_folder.hpp"
#include "inspect/view_comparison.hpp"
#include "map/view_capture.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr int least_captures = 4;
// The level of a comparison of all captures before and after the work, per level of a comparison of the
// halves. A half has half as many captures: the root of two. The halves were taken from different poses,
// while a robot that returns to within half a servo step sees most dots of its projector at the same
// positions again, so that part of the errors of both sides is the same: another 1.41 (1.27 to 1.55 in five
// simulated bays, geometric mean; docs/console.md).
constexpr float level_of_all_per_half = 0.5F;

void write_pictures(const Detection& detection, const fs::path& folder) {
  std::error_code ignored;  // write_file() reports the error
  fs::create_directories(folder, ignored);
  if (const auto& level = detection.level_of_detection)
    write_file(folder / "level_of_detection.png", encode_png(draw_level_of_detection(level->least_mm)));
  write_file(folder / "depth_overlay.png",
             encode_png(draw_on_depth(detection.final_m, detection.findings.findings)));
}

Json json_of(const Detection& detection, const Intrinsics& camera) {
  Json json{{"false_findings", detection.findings.findings.size()}};
  if (detection.level_of_detection) json["level_of_detection"] = json_of(level_summary(detection, camera));
  return json;
}

// A view whose halves cannot be compared cannot be compared after the work either. The reason is recorded for
// the user instead of ending the check.
Json check_view(const InspectionFolder& folder, const Inspection& inspection, int view,
                const fs::path& pictures, const Progress& progress) {
  Json json{{"view", view}};
  std::optional<Detection> expected;
  Intrinsics camera;
  try {
    Captures baseline = open_captures(folder, inspection, Side::initial, view);
    camera = baseline.front()->info().depth;
    expected = expected_detection(std::move(baseline), progress);
  } catch (const Error& error) {
    json["problem"] = error.what();
    return json;
  }
  write_pictures(*expected, pictures);
  json.update(json_of(*expected, camera));
  return json;
}

}  // namespace

std::vector<std::string> baseline_check_files() {
  return {"check.json", "[0-9][0-9][0-9]/level_of_detection.png", "[0-9][0-9][0-9]/depth_overlay.png"};
}

Detection expected_detection(Captures baseline, const Progress& progress) {
  const std::size_t half = baseline.size() / 2;
  const auto middle = std::make_move_iterator(baseline.begin() + static_cast<std::ptrdiff_t>(half));
  const Captures second(middle, middle + static_cast<std::ptrdiff_t>(half));
  baseline.resize(half);
  Detection detection = detect(baseline, second, {}, progress).detection;
  if (auto& level = detection.level_of_detection) {
    for (float& least_mm : level->least_mm.pixels()) least_mm *= level_of_all_per_half;
    level->summary.by_distance = levels_by_distance(level->least_mm, detection.final_m);
  }
  return detection;
}

void check_baseline(const InspectionFolder& folder, const Inspection& inspection, const Progress& progress) {
  std::error_code unknown;
  if (inspection.dither < least_captures || fs::exists(folder.baseline_check(), unknown)) return;
  folder.require_no_links(folder.path());
  OutputFolder out(folder.baseline_check(), baseline_check_files(), Existing::refuse);
  Json views = Json::array();
  for (int view = 0; view < static_cast<int>(inspection.views.size()); ++view) {
    throw_if_interrupted();
    const Progress in_view = [&](std::string_view /*step*/, std::size_t /*done*/, std::size_t /*total*/) {
      if (progress) progress("checking", static_cast<std::size_t>(view), inspection.views.size());
    };
    in_view("", 0, 0);
    views.push_back(
        check_view(folder, inspection, view, out.path(view_name(static_cast<std::size_t>(view))), in_view));
  }
  const Json check{{"format", "rva-baseline-check"},
                   {"version", 1},
                   {"captures", inspection.dither / 2},
                   {"views", std::move(views)}};
  write_file(out.path("check.json"), json_file_text(check));
  out.commit();
}

}  // namespace rva
