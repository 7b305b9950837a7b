#include "inspect/view_comparison.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "classify/finding_classes.hpp"
#include "classify/finding_model.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "detect/detect.hpp"
#include "detect/findings/height_above_surroundings.hpp"
#include "detect/provenance.hpp"
#include "detect/result_folder.hpp"
#include "inspect/inspection_map.hpp"
#include "inspect/planned_findings.hpp"
#include "inspect/review_pictures.hpp"
#include "map/point_files.hpp"

namespace rva {
namespace {

/// A view's captures, and the changes between them in the view of the first final capture.
struct ViewResult {
  Captures initial;
  Captures final;
  SidesDetection changes;
  Provenance provenance;
  std::optional<PlanMatch> match{};  ///< if the view has a plan
  ShownFindings shown{};
  FindingClasses classes{};

  [[nodiscard]] const Detection& detection() const { return changes.detection; }
};

/// The planes of findings by view and id.
using ShownByView = std::map<std::pair<int, int>, cv::Mat>;

// Paths of a view's captures relative to the inspection's folder, which may be copied elsewhere.
std::vector<std::filesystem::path> capture_paths(const InspectionFolder& folder, const Inspection& inspection,
                                                 Side side, int view) {
  std::vector<std::filesystem::path> paths;
  for (int k = 0; k < inspection.dither; ++k)
    paths.push_back(folder.capture(side, inspection, view, k).lexically_relative(folder.path()));
  return paths;
}

ViewResult compare(const InspectionFolder& folder, const Inspection& inspection, int view,
                   FindingModel& model, const Progress& progress) {
  ViewResult result{open_captures(folder, inspection, Side::initial, view),
                    open_captures(folder, inspection, Side::final, view),
                    {},
                    {},
                    {},
                    {},
                    {}};
  const auto ignored = inspection.ignored.find(view);
  const Intrinsics& camera = result.initial.front()->info().depth;
  const Mask left_out = ignored == inspection.ignored.end()
                            ? Mask()
                            : mask_of({ignored->second, {}}, camera.width, camera.height);
  result.provenance = {time_of_making(),
                       sources_of(capture_paths(folder, inspection, Side::initial, view), result.initial),
                       sources_of(capture_paths(folder, inspection, Side::final, view), result.final)};
  result.changes = detect(result.initial, result.final, {}, progress, left_out);
  if (const auto plan = inspection.planned.find(view); plan != inspection.planned.end())
    result.match = match_plan(plan->second, result.detection(), {camera, result.final.front()->info().depth},
                              PlanOptions{});
  result.shown = shown_findings(result.detection(), *result.final.front());
  result.classes = classify(result.shown, model);
  return result;
}

// @return the picture ReviewPictures::changed
ColorImage write(const ViewResult& result, const FindingModel& model, const std::filesystem::path& folder) {
  std::error_code ignored;  // write_result() reports the error
  std::filesystem::create_directories(folder, ignored);
  nlohmann::ordered_json detections = detections_json(result.changes.detection.findings, result.provenance);
  if (result.match) {
    add_plan(*result.match, detections);
    write_file(folder / result_file::plan, json_file_text(json_of(*result.match)));
  }
  add_classes(result.classes, described(model), detections);
  // Its warnings are of pictures that the review does not show: it has those of ReviewPictures.
  static_cast<void>(write_result(result.changes, *result.final.front(), folder, detections));
  ReviewPictures pictures = draw_review(*result.initial.front(), *result.final.front(), result.detection());
  write_review(pictures, folder);
  return std::move(pictures.changed);
}

ComparedView summary_of(const ViewResult& result, int view) {
  const Detection& detection = result.detection();
  ComparedView summary;
  summary.view = view;
  summary.method = detection.findings.method;
  summary.coverage = detection.findings.coverage;
  summary.judged = detection.level_of_detection ? detection.level_of_detection->summary.judged
                                                : detection.findings.coverage.compared;
  summary.warnings = detection.warnings;
  if (detection.level_of_detection)
    summary.findable = level_summary(detection, result.final.front()->info().depth).findable;
  if (result.match) summary.planned = planned_work(*result.match);
  return summary;
}

// In pictures in colour, what is beyond the colour imager's view is grey.
bool is_in_color(const CaptureInfo& info, const Eigen::Vector3d& point_m) {
  if (!info.color) return true;
  const Eigen::Vector3d seen = info.color_from_depth.value_or(Transform::Identity()) * point_m;
  if (seen.z() <= 0.0) return false;
  const Eigen::Vector2d pixel = info.color->project(seen);
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= info.color->width - 1.0 &&
         pixel.y() <= info.color->height - 1.0;
}

int clear_px(const Finding& finding, const Detection& detection, const CaptureInfo& info) {
  const int width = detection.final_m.width();
  if (reaches_border(finding.pixels, width, detection.final_m.height())) return 0;
  const bool gone = finding.kind == ChangeKind::removed && !detection.initial_m.empty();
  const Image<float>& depth_m = gone ? detection.initial_m : detection.final_m;
  return static_cast<int>(std::ranges::count_if(finding.pixels, [&](std::uint32_t pixel) {
    if (!(depth_m[pixel] > 0.0F)) return false;
    const auto at = static_cast<int>(pixel);
    return is_in_color(info, info.depth.deproject(Eigen::Vector2d(at % width, at / width), depth_m[pixel]));
  }));
}

void add_class(const FindingClasses& classes, ReviewedFinding& reviewed) {
  const auto found = std::ranges::find(classes.findings, reviewed.finding.id, &FindingClass::finding);
  if (found == classes.findings.end()) return;
  reviewed.likely_class = found->name;
  reviewed.class_probability = found->probability;
}

// @param plan of this view, if it has one
std::vector<ReviewedFinding> findings_of(const ViewResult& result, int view, const Plan* plan,
                                         const PanTiltChain& chain) {
  const Transform foot_from_final = map_from_camera(result.final.front()->info(), chain);
  std::vector<ReviewedFinding> findings;
  for (const Finding& finding : result.detection().findings.findings) {
    ReviewedFinding reviewed;
    reviewed.finding = finding;
    reviewed.finding.pixels.clear();
    reviewed.clear_px = clear_px(finding, result.detection(), result.final.front()->info());
    add_class(result.classes, reviewed);
    findings.push_back(std::move(reviewed));
  }
  if (plan != nullptr)
    add_planned(findings, result.match.value(), *plan, result.detection(), *result.initial.front(),
                result.final.front()->info());
  for (ReviewedFinding& reviewed : findings) {
    reviewed.view = view;
    if (reviewed.finding.position_m) reviewed.in_foot_m = foot_from_final * *reviewed.finding.position_m;
  }
  return findings;
}

bool is_missing(const ReviewedFinding& finding) { return finding.planned == PlannedState::missing; }

// What was not planned needs a look first, then what is missing or too many; what was planned comes last.
int urgency(const ReviewedFinding& finding) {
  switch (finding.planned.value_or(PlannedState::unplanned)) {
    case PlannedState::unplanned:
      return 3;
    case PlannedState::missing:
      return 2;
    case PlannedState::surplus:
      return 1;
    case PlannedState::planned:
      return 0;
  }
  return 0;
}

bool is_same_thing(const ReviewedFinding& a, const ReviewedFinding& b, double reach_m) {
  return a.view != b.view && is_missing(a) == is_missing(b) && a.finding.kind == b.finding.kind &&
         a.in_foot_m && b.in_foot_m && (*a.in_foot_m - *b.in_foot_m).norm() < reach_m;
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

// The planes of findings that have a class, in the order of their numbers.
std::string planes_by_number(const std::vector<ReviewedFinding>& findings, const ShownByView& shown) {
  std::vector<cv::Mat> planes;
  for (const ReviewedFinding& finding : findings)
    if (!finding.likely_class.empty()) planes.push_back(shown.at({finding.view, finding.finding.id}));
  return npy_of(planes);
}

}  // namespace

std::vector<std::string> view_result_files() {
  std::vector<std::string> files = result_files();
  std::ranges::copy(review_picture_files(), std::back_inserter(files));
  return files;
}

std::vector<std::string> comparison_files() {
  std::vector<std::string> files{"map.ply", "changes.ply", InspectionFolder::shown_findings};
  for (const std::string& name : view_result_files()) files.push_back("results/[0-9][0-9][0-9]/" + name);
  return files;
}

std::vector<ReviewedFinding> rank(std::vector<ReviewedFinding> findings, double reach_m) {
  std::ranges::stable_sort(findings, std::greater<>{}, [](const ReviewedFinding& finding) {
    return std::tuple(urgency(finding), finding.finding.evidence.depth, finding.finding.score.value_or(0.0));
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

Compared compare_sides(const InspectionFolder& folder, const Inspection& inspection,
                       const std::filesystem::path& out, bool moved, const PanTiltChain& chain,
                       const Progress& progress) {
  OutputFolder results(out, comparison_files(), Existing::refuse);
  Compared compared;
  std::vector<ReviewedFinding> findings;
  std::vector<MapPoint> points;
  ShownByView shown;
  FindingModel model = FindingModel::shipped();
  for (int view = 0; view < static_cast<int>(inspection.views.size()); ++view) {
    throw_if_interrupted();
    // Reported again at each step of a view, so that the user can cancel the comparison there.
    const Progress views = [&](std::string_view /*step*/, std::size_t /*done*/, std::size_t /*total*/) {
      if (progress) progress("comparing", static_cast<std::size_t>(view), inspection.views.size() + 1);
    };
    views("", 0, 0);
    const ViewResult result = compare(folder, inspection, view, model, views);
    const ColorImage changed = write(result, model, InspectionFolder::result_in(results.path(""), view));
    const CaptureInfo& info = result.final.front()->info();
    std::ranges::move(changed_points(result.detection(), changed, info.depth, map_from_camera(info, chain)),
                      std::back_inserter(points));
    compared.views.push_back(summary_of(result, view));
    const auto plan = inspection.planned.find(view);
    const Plan* const view_plan = plan == inspection.planned.end() ? nullptr : &plan->second;
    std::ranges::move(findings_of(result, view, view_plan, chain), std::back_inserter(findings));
    for (const ShownFinding& one : result.shown.findings) shown[{view, one.finding}] = one.planes;
  }
  write_inspection_map(results.path("map.ply"), folder, inspection, moved, chain);
  write_ply(results.path("changes.ply"), points, PointFrame::robot_foot);
  compared.findings = rank(std::move(findings));
  write_file(results.path(InspectionFolder::shown_findings), planes_by_number(compared.findings, shown));
  results.commit();
  return compared;
}

}  // namespace rva
