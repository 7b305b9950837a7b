#include "inspect/view_comparison.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/output_folder.hpp"
#include "depth/image_file.hpp"
#include "detect/detect.hpp"
#include "detect/findings/drawing.hpp"
#include "inspect/inspection_map.hpp"
#include "inspect/review_pictures.hpp"
#include "map/point_files.hpp"

namespace rva {
namespace {

/// A view's captures, and the changes between them in the view of the first final capture.
struct ViewResult {
  Captures initial;
  Captures final;
  Detection detection;
};

ViewResult compare(const InspectionFolder& folder, const Inspection& inspection, int view,
                   const Progress& progress) {
  ViewResult result{open_captures(folder, inspection, Side::initial, view),
                    open_captures(folder, inspection, Side::final, view),
                    {}};
  const auto ignored = inspection.ignored.find(view);
  const Intrinsics& camera = result.initial.front()->info().depth;
  const Mask left_out = ignored == inspection.ignored.end()
                            ? Mask()
                            : mask_of({ignored->second, {}}, camera.width, camera.height);
  result.detection = detect(result.initial, result.final, {}, progress, left_out).detection;
  return result;
}

void write_picture(const std::filesystem::path& file, const ColorImage& picture) {
  if (!picture.empty()) write_file(file, encode_png(picture));
}

// @return the picture ReviewPictures::changed
ColorImage write(const ViewResult& result, const std::filesystem::path& folder) {
  const Detection& detection = result.detection;
  std::error_code ignored;  // write_file() reports the error
  std::filesystem::create_directories(folder, ignored);
  write_file(folder / "detections.json", to_json(detection.findings));
  write_file(folder / "changes.png", encode_png(detection.changed));
  write_picture(folder / "depth_overlay.png",
                draw_on_depth(detection.final_m, detection.findings.findings, detection.left_out));
  if (const auto& level = detection.level_of_detection) {
    write_picture(folder / "level_of_detection.png", draw_level_of_detection(level->least_mm));
    write_file(folder / "level_of_detection.json", to_json(level->summary));
  }
  ReviewPictures pictures = draw_review(*result.initial.front(), *result.final.front(), detection);
  write_picture(folder / "initial_color.png", pictures.initial_color);
  write_picture(folder / "final_color.png", pictures.final_color);
  write_picture(folder / "initial_depth.png", pictures.initial_depth);
  write_picture(folder / "final_depth.png", pictures.final_depth);
  write_picture(folder / "changed.png", pictures.changed);
  write_picture(folder / "not_inspected.png", pictures.not_inspected);
  return std::move(pictures.changed);
}

ComparedView summary_of(const Detection& detection, int view) {
  ComparedView summary;
  summary.view = view;
  summary.method = detection.findings.method;
  summary.coverage = detection.findings.coverage;
  summary.judged = detection.level_of_detection ? detection.level_of_detection->summary.judged
                                                : detection.findings.coverage.compared;
  summary.warnings = detection.warnings;
  return summary;
}

std::vector<ReviewedFinding> findings_of(const ViewResult& result, int view, const PanTiltChain& chain) {
  const Transform foot_from_final = map_from_camera(result.final.front()->info(), chain);
  std::vector<ReviewedFinding> findings;
  for (const Finding& finding : result.detection.findings.findings) {
    ReviewedFinding reviewed;
    reviewed.view = view;
    reviewed.finding = finding;
    reviewed.finding.pixels.clear();
    if (finding.position_m) reviewed.in_foot_m = foot_from_final * *finding.position_m;
    findings.push_back(std::move(reviewed));
  }
  return findings;
}

bool is_same_thing(const ReviewedFinding& a, const ReviewedFinding& b, double reach_m) {
  return a.view != b.view && a.finding.kind == b.finding.kind && a.in_foot_m && b.in_foot_m &&
         (*a.in_foot_m - *b.in_foot_m).norm() < reach_m;
}

// Converts Finding::moved_from, an id within one view, to the number within the inspection.
void name_moved_things(std::vector<ReviewedFinding>& findings) {
  for (ReviewedFinding& finding : findings) {
    if (!finding.finding.moved_from) continue;
    const auto from = std::ranges::find_if(findings, [&](const ReviewedFinding& other) {
      return other.view == finding.view && other.finding.id == *finding.finding.moved_from;
    });
    if (from != findings.end()) finding.moved_from = from->number;
  }
}

}  // namespace

std::vector<std::string> view_result_files() {
  return {"detections.json",         "changes.png",       "depth_overlay.png", "level_of_detection.png",
          "level_of_detection.json", "initial_color.png", "final_color.png",   "initial_depth.png",
          "final_depth.png",         "changed.png",       "not_inspected.png"};
}

std::vector<std::string> comparison_files() {
  std::vector<std::string> files{"map.ply", "changes.ply"};
  for (const std::string& name : view_result_files()) files.push_back("results/[0-9][0-9][0-9]/" + name);
  return files;
}

std::vector<ReviewedFinding> rank(std::vector<ReviewedFinding> findings, double reach_m) {
  std::ranges::stable_sort(findings, std::greater<>{}, [](const ReviewedFinding& finding) {
    return std::pair(finding.finding.evidence.depth, finding.finding.score.value_or(0.0));
  });
  int number = 0;
  for (ReviewedFinding& finding : findings) {
    finding.number = ++number;
    const auto same =
        std::ranges::find_if(findings.begin(), findings.begin() + (number - 1), [&](const auto& other) {
          return other.same_as == other.number && is_same_thing(other, finding, reach_m);
        });
    const bool is_new = same == findings.begin() + (number - 1);
    finding.same_as = is_new ? number : same->number;
  }
  name_moved_things(findings);
  return findings;
}

Captures open_captures(const InspectionFolder& folder, const Inspection& inspection, Side side, int view) {
  Captures captures;
  for (int k = 0; k < inspection.dither; ++k)
    captures.push_back(open_capture(folder.capture(side, inspection, view, k)));
  return captures;
}

Compared compare_sides(const InspectionFolder& folder, const Inspection& inspection, int number, bool moved,
                       const PanTiltChain& chain, const Progress& progress) {
  OutputFolder out(folder.path() / InspectionFolder::comparison_name(number), comparison_files(),
                   Existing::refuse);
  Compared compared;
  std::vector<ReviewedFinding> findings;
  std::vector<MapPoint> points;
  for (int view = 0; view < static_cast<int>(inspection.views.size()); ++view) {
    throw_if_interrupted();
    // Reported again at each step of a view, so that the user can cancel the comparison there.
    const Progress views = [&](std::string_view /*step*/, std::size_t /*done*/, std::size_t /*total*/) {
      if (progress) progress("comparing", static_cast<std::size_t>(view), inspection.views.size() + 1);
    };
    views("", 0, 0);
    const ViewResult result = compare(folder, inspection, view, views);
    const ColorImage changed = write(result, InspectionFolder::result_in(out.path(""), view));
    const CaptureInfo& info = result.final.front()->info();
    std::ranges::move(changed_points(result.detection, changed, info.depth, map_from_camera(info, chain)),
                      std::back_inserter(points));
    compared.views.push_back(summary_of(result.detection, view));
    std::ranges::move(findings_of(result, view, chain), std::back_inserter(findings));
  }
  write_inspection_map(out.path("map.ply"), folder, inspection, moved, chain);
  write_ply(out.path("changes.ply"), points, PointFrame::robot_foot);
  out.commit();
  compared.findings = rank(std::move(findings));
  return compared;
}

}  // namespace rva
