#include "detect/detect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "capture/capture_view.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "detect/appearance/appearance_detection.hpp"
#include "detect/genuine_captures.hpp"
#include "detect/spatial/lit_capture.hpp"
#include "detect/spatial/surface_support.hpp"
#include "geometry/rigid_motion.hpp"
#include "views/view_check.hpp"

namespace rva {
namespace {

bool is_of_the_thesis(DetectionMethod method) {
  return method == DetectionMethod::constant || method == DetectionMethod::gaussian ||
         method == DetectionMethod::octree;
}

// How many frames of each capture a method uses; 0 for all.
std::size_t frames_used(const DetectOptions& options) {
  const bool first_only =
      options.method == DetectionMethod::constant || options.method == DetectionMethod::octree;
  return first_only ? 1 : static_cast<std::size_t>(options.static_camera.use.frames);
}

// Finds the initial capture with the pose of the first final one, since a pixel by pixel comparison requires
// an exact return.
const Capture& initial_of_same_view(const Captures& initial, const Capture& final) {
  if (initial.size() == 1) return *initial.front();
  const auto same = std::ranges::find_if(
      initial, [&](const auto& capture) { return !poses_differ(capture->info(), final.info()); });
  if (same == initial.end())
    throw Error("initial captures", "none was taken from the pose of the first final capture",
                "use the spatial method");
  return **same;
}

DepthView view_of(const DepthStatistics& statistics, const CaptureInfo& info) {
  return depth_view(statistics, info.depth, stereo_scale(info));
}

/// The views of a static comparison, and whether they are aligned.
struct CheckedViews {
  DepthView initial;
  DepthView final;
  ViewCheck check;

  [[nodiscard]] Registration registration() const {
    return check.registration ? *check.registration : register_near_views(initial, final);
  }
};

// Empty with lens distortion, for which views cannot be checked: planes in space are not planes in disparity.
std::optional<CheckedViews> checked_views(const StaticDetection& compared, const CaptureInfo& initial,
                                          const CaptureInfo& final) {
  if (final.depth.distortion != Distortion::none) return std::nullopt;
  CheckedViews views{view_of(compared.initial, initial), view_of(compared.final, final), {}};
  views.check = check_views(views.initial, views.final);
  return views;
}

// Describes a motion, as in "turned by 1.02 degrees and shifted by 0.4 mm".
std::string motion_text(const Transform& initial_from_final) {
  const double turn_deg = angle_deg_of(initial_from_final);
  const double shift_mm = mm_per_m * initial_from_final.translation().norm();
  return fmt::format("turned by {:.2g} degrees and shifted by {:.2g} mm", turn_deg, shift_mm);
}

class Run {
 public:
  Run(const Captures& initial, const Captures& final, const DetectOptions& options, const Progress& progress,
      const Mask& left_out)
      : initial_(initial), final_(final), options_(options), progress_(progress), left_out_(left_out) {
    check_options(options);
    const Intrinsics& camera = initial.front()->info().depth;
    if (!left_out.empty() && (left_out.width() != camera.width || left_out.height() != camera.height))
      throw Error("region to leave out",
                  fmt::format("of {}x{} pixels where the initial depth image has {}x{}", left_out.width(),
                              left_out.height(), camera.width, camera.height),
                  "draw it on the initial depth image");
  }

  SidesDetection run() {
    SidesDetection result = run_method();
    add_depth_notes("initial", *initial_.front(), result.detection.warnings);
    add_depth_notes("final", *final_.front(), result.detection.warnings);
    return result;
  }

 private:
  static void add_depth_notes(std::string_view side, const Capture& capture,
                              std::vector<std::string>& warnings) {
    for (const std::string& note : capture.info().notes)
      warnings.push_back(fmt::format("{} capture: {}", side, note));
    for (const std::string& note : capture.depth_notes())
      warnings.push_back(fmt::format("{} capture: {}", side, note));
  }

  SidesDetection run_method() {
    if (is_static(options_.method)) return by_name();
    if (options_.method == DetectionMethod::automatic) return automatic();
    warn_of_other_camera();
    return options_.method == DetectionMethod::octree ? octree() : spatial();
  }

  [[nodiscard]] const CaptureInfo& initial_info() const { return initial_.front()->info(); }
  [[nodiscard]] const CaptureInfo& final_info() const { return final_.front()->info(); }
  [[nodiscard]] bool has_several() const { return initial_.size() + final_.size() > 2; }

  SidesDetection automatic() {
    require_one_device(initial_info(), final_info());
    if (has_several() || poses_differ(initial_info(), final_info())) return spatial();
    const Capture& initial = *initial_.front();
    const ComparedImages images = still_images(initial_, final_);
    StaticDetection compared = compare_pixels(initial, images.lights.empty() ? 1.0 : share_of_depth);
    const std::optional<CheckedViews> views = checked_views(compared, initial_info(), final_info());
    if (!views) return {std::move(compared.detection), std::nullopt};
    if (views->check.is_aligned()) {
      if (images.any()) add_images(images, *views, compared);
      return {std::move(compared.detection), std::nullopt};
    }
    return spatial_after(*views, std::move(compared.detection));
  }

  // Whether colour images can be compared is only known after comparing them; until then, depth has all of
  // the allowed false findings.
  void add_images(const ComparedImages& images, const CheckedViews& views, StaticDetection& compared) {
    const Capture& initial = *initial_.front();
    std::vector<std::string> warnings;
    ImageChanges changes = still_changes(initial, *final_.front(), images, views.final, warnings);
    if (changes.any() && images.lights.empty()) compared = compare_pixels(initial, share_of_depth);
    std::ranges::move(warnings, std::back_inserter(compared.detection.warnings));
    if (!changes.any()) return;
    add_still_appearance(std::move(changes), views.final,
                         (1.0 - share_of_depth) * options_.static_camera.calibrated.false_findings,
                         options_.static_camera.regions, compared.detection);
  }

  // Handles views that are not aligned: registers them and compares with `spatial`.
  SidesDetection spatial_after(const CheckedViews& views, Detection compared) {
    const Registration registration = views.registration();
    if (!registration.trusted() && views.check.shows_other_view())
      throw RegistrationRefused(
          "initial and final",
          fmt::format("the captures do not show the same view, and their views cannot be registered ({})",
                      registration.doubt),
          "give the baseline of this bay, taken from nearly the same pose; the calibrated method "
          "compares pixel by pixel regardless");
    if (!registration.trusted()) {
      compared.warnings.push_back(warning_of_motion(views.check, registration));
      return {std::move(compared), std::nullopt};
    }
    SidesDetection result = spatial(KnownMotion::bumped);
    result.detection.warnings.insert(
        result.detection.warnings.begin(),
        fmt::format("the camera {} between the captures: their views were registered and compared with the "
                    "spatial method",
                    motion_text(registration.initial_from_final)));
    return result;
  }

  SidesDetection by_name() {
    const Capture& initial = initial_of_same_view(initial_, *final_.front());
    StaticDetection compared = compare_pixels(initial);
    std::vector<std::string>& warnings = compared.detection.warnings;
    if (has_several())
      warnings.push_back(fmt::format("method {} compared one capture of each side: the others were not used",
                                     name_of(options_.method)));
    if (poses_differ(initial.info(), final_info()))
      warnings.emplace_back(
          "according to their poses, the camera moved between the captures: pixels were compared regardless, "
          "and findings may be due to the motion");
    else if (const auto views = checked_views(compared, initial.info(), final_info());
             views && !views->check.is_aligned())
      warnings.push_back(warning_of_motion(views->check, views->registration()));
    return {std::move(compared.detection), std::nullopt};
  }

  static std::string warning_of_motion(const ViewCheck& check, const Registration& registration) {
    if (registration.trusted())
      return fmt::format(
          "the camera {} between the captures: pixels were compared regardless, and edges may be reported as "
          "changes; the auto method registers the views first",
          motion_text(registration.initial_from_final));
    if (check.shows_other_view())
      return fmt::format(
          "the captures do not show the same view ({}): pixels were compared regardless, but the result is "
          "not meaningful",
          registration.doubt);
    return fmt::format(
        "the camera moved by about {:.2g} pixels between the captures, and the views cannot be registered "
        "({}): edges may be reported as changes",
        check.motion.displacement_px, registration.doubt);
  }

  // @param share of the allowed false findings
  StaticDetection compare_pixels(const Capture& initial, double share = 1.0) {
    StaticDetectionOptions options = options_.static_camera;
    options.calibrated.false_findings *= share;
    options.method = is_static(options_.method) ? options_.method : DetectionMethod::calibrated;
    return detect_static(initial, *final_.front(), options, progress_, left_out_);
  }

  SidesDetection spatial(KnownMotion known = KnownMotion::moved) {
    const StaticDetectionOptions& shared = options_.static_camera;
    const ComparedImages images = comparable_images(initial_, final_, warnings_);
    SpatialDetectionOptions options{shared.use, shared.calibrated, shared.regions, known};
    if (images.any()) options.share = share_of_depth;
    options.pairs = have_pairs(initial_, final_);
    SpatialDetection found = detect_spatial(initial_, final_, options, progress_, left_out_);
    if (images.any())
      add_appearance(initial_, final_, images, found.placed,
                     (1.0 - share_of_depth) * shared.calibrated.false_findings, shared.regions,
                     found.detection);
    prepend_warnings(found.detection);
    return {std::move(found.detection), std::move(found.registration)};
  }

  SidesDetection octree() {
    Detection found = detect_by_octree(*initial_.front(), *final_.front(), options_.octree,
                                       options_.static_camera.regions, progress_, left_out_);
    if (has_several())
      warnings_.emplace_back("method octree compared one capture of each side: the others were not used");
    prepend_warnings(found);
    return {std::move(found), std::nullopt};
  }

  void warn_of_other_camera() {
    try {
      require_one_device(initial_info(), final_info());
    } catch (const Error& error) {
      warnings_.emplace_back(error.what());
    }
  }

  void prepend_warnings(Detection& detection) {
    detection.warnings.insert(detection.warnings.begin(), warnings_.begin(), warnings_.end());
  }

  const Captures& initial_;
  const Captures& final_;
  const DetectOptions& options_;
  const Progress& progress_;
  const Mask& left_out_;
  std::vector<std::string> warnings_;
};

// Both sides with depth in the coarsest unit of all captures: in a finer unit, large depths would not fit
// into 16 bits.
struct SidesInOneUnit {
  SidesInOneUnit(const Captures& initial_captures, const Captures& final_captures) {
    std::set<double> units_m;
    for (const Captures* side : {&initial_captures, &final_captures}) {
      for (const auto& capture : *side) units_m.insert(capture->info().depth_unit_m);
    }
    const double finest_m = *units_m.begin();
    const double coarsest_m = *units_m.rbegin();
    if (!is_same_unit(finest_m, coarsest_m))
      note = fmt::format(
          "the captures state depth in steps of {:.6g} mm and of {:.6g} mm: they were compared in steps of "
          "{:.6g} mm",
          mm_per_m * finest_m, mm_per_m * coarsest_m, mm_per_m * coarsest_m);
    initial = converted(initial_captures, coarsest_m);
    final = converted(final_captures, coarsest_m);
  }

  Captures initial;
  Captures final;
  std::string note;  ///< empty if all have the same unit

 private:
  static Captures converted(const Captures& side, double unit_m) {
    Captures result;
    for (const auto& capture : side) {
      if (is_same_unit(capture->info().depth_unit_m, unit_m))
        result.push_back(std::make_unique<CaptureView>(*capture, capture->info()));
      else
        result.push_back(in_unit(*capture, unit_m));
    }
    return result;
  }
};

SidesDetection detect_in_one_unit(const Captures& initial, const Captures& final,
                                  const DetectOptions& options, const Progress& progress,
                                  const Mask& left_out) {
  if (is_of_the_thesis(options.method)) return Run(initial, final, options, progress, left_out).run();
  const LitSides lit = within_projector_field(initial, final);
  return Run(lit.initial, lit.final, options, progress, left_out).run();
}

}  // namespace

SidesDetection detect(const Captures& initial, const Captures& final, const DetectOptions& options,
                      const Progress& progress, const Mask& left_out) {
  check_options(options);
  require_genuine(initial, final, frames_used(options));
  const SidesInOneUnit sides(initial, final);
  SidesDetection result = detect_in_one_unit(sides.initial, sides.final, options, progress, left_out);
  if (!sides.note.empty()) result.detection.warnings.push_back(sides.note);
  return result;
}

}  // namespace rva
