#include "detect/result_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/image_file.hpp"
#include "detect/findings/drawing.hpp"

namespace rva {
namespace {

// Empty where there is no colour image to draw on, with a warning that states why.
std::optional<ColorImage> color_to_draw_on(const Capture& final, std::vector<std::string>& warnings) {
  if (final.color_frames() == 0) {
    warnings.push_back(
        fmt::format("the final capture has no colour image, so there is no {}", result_file::overlay));
    return std::nullopt;
  }
  try {
    return final.color(0);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("there is no {}: {}", result_file::overlay, error.what()));
    return std::nullopt;
  }
}

ColorImage color_overlay(const CaptureInfo& info, const ColorImage& color, const Detection& detection,
                         std::vector<std::string>& warnings) {
  if (!detection.findings.findings.empty() && !(info.color && info.color_from_depth))
    warnings.push_back(fmt::format(
        "the final capture does not state the pose of its colour imager relative to its depth imager: boxes "
        "in {} are only approximate; {} shows them exactly",
        result_file::overlay, result_file::depth_overlay));
  Overlay overlay = draw_on_color(color, detection.findings.findings, detection.final_m, info);
  if (overlay.outside > 0)
    warnings.push_back(fmt::format("{} finding(s) lie outside the colour camera's view; {} shows them",
                                   overlay.outside, result_file::depth_overlay));
  return std::move(overlay.picture);
}

}  // namespace

std::vector<std::string> result_files() {
  std::vector<std::string> names;
  for (const std::string_view name :
       {result_file::detections, result_file::changes, result_file::depth_overlay, result_file::overlay,
        result_file::changed_points, result_file::registration, result_file::level,
        result_file::level_picture, result_file::plan})
    names.emplace_back(name);
  return names;
}

DetectionLevelSummary level_summary(const Detection& detection, const Intrinsics& final) {
  const LevelOfDetection& level = *detection.level_of_detection;
  DetectionLevelSummary summary = level.summary;
  state_widths(summary, final.fx);
  summary.findable = findable_shares(level.least_mm, detection.final_m, summary.window_px, final.fx);
  return summary;
}

nlohmann::ordered_json detections_json(const Findings& findings,
                                       const std::optional<Provenance>& provenance) {
  nlohmann::ordered_json json = json_of(findings);
  if (provenance) json["provenance"] = json_of(*provenance);
  return json;
}

std::vector<std::string> write_result(const SidesDetection& result, const Capture& final,
                                      const std::filesystem::path& folder,
                                      const nlohmann::ordered_json& detections) {
  const Detection& detection = result.detection;
  std::vector<std::string> warnings;
  write_file(folder / result_file::detections, json_file_text(detections));
  write_file(folder / result_file::changes, encode_png(detection.changed));
  write_file(folder / result_file::depth_overlay,
             encode_png(draw_on_depth(detection.final_m, detection.findings.findings, detection.left_out)));
  if (const auto color = color_to_draw_on(final, warnings)) {
    write_file(folder / result_file::overlay,
               encode_png(color_overlay(final.info(), *color, detection, warnings)));
    if (detection.findings.method == name_of(DetectionMethod::octree))
      write_file(folder / result_file::changed_points,
                 encode_png(draw_changed_points(*color, detection.changed, detection.final_m, final.info())));
  }
  if (result.registration)
    write_file(folder / result_file::registration, json_file_text(json_of(*result.registration)));
  if (const auto& level = detection.level_of_detection) {
    write_file(folder / result_file::level_picture, encode_png(draw_level_of_detection(level->least_mm)));
    write_file(folder / result_file::level,
               json_file_text(json_of(level_summary(detection, final.info().depth))));
  }
  return warnings;
}

}  // namespace rva
