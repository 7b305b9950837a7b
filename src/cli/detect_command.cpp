#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "cloud/octree_detection.hpp"
#include "cloud/spatial_detection.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "depth/image_file.hpp"
#include "detect/drawing.hpp"
#include "detect/static_detection.hpp"

namespace rva::cli {
namespace {

constexpr std::array static_methods{StaticMethod::constant, StaticMethod::gaussian, StaticMethod::calibrated};

constexpr std::string_view spatial = "spatial";
constexpr std::string_view octree = "octree";

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const StaticMethod method : static_methods) names.emplace_back(name_of(method));
  names.emplace_back(spatial);
  names.emplace_back(octree);
  return names;
}

struct DetectArguments {
  std::string initial;
  std::string final;
  std::vector<std::string> initial_side;
  std::vector<std::string> final_side;
  std::string out;
  CaptureFlags captures;
  std::string method;  // empty: by what the captures say
  StaticDetectionOptions detection;
  OctreeOptions octree;
  bool overwrite = false;
  bool json = false;
  bool fail_on_detection = false;
};

// Boxes on colour need a colour picture; without one the result simply has no such file.
void write_color_overlay(const Capture& final, const Detection& detection, const OutputFolder& out,
                         std::vector<std::string>& warnings) {
  if (final.color_frames() == 0) {
    warnings.emplace_back("the final capture has no colour image, so there is no overlay.png");
    return;
  }
  const Overlay overlay =
      draw_on_color(final.color(0), detection.findings.findings, detection.final_m, final.info());
  if (overlay.outside > 0) {
    warnings.push_back(fmt::format(
        "{} finding(s) lie outside the colour camera's view; depth_overlay.png shows them", overlay.outside));
  }
  write_file(out.path("overlay.png"), encode_png(overlay.picture));
}

void print_levels(const DetectionLevelSummary& summary) {
  print(
      "judged {:.1f} % of the view; there, what shows {} pixels wide would have been found from this "
      "height:\n",
      100.0 * summary.judged, summary.window_px);
  for (const DetectionLevels& levels : summary.by_distance)
    print("{:>9.1f}-{:.1f} m: {:.1f} mm in half of it, {:.1f} mm in nine tenths\n", levels.from_m,
          levels.to_m, levels.median_mm, levels.p90_mm);
}

// What a method cannot give is not faked.
std::string or_none(const char* format, std::optional<double> number) {
  return number ? fmt::format(fmt::runtime(format), *number) : "-";
}

void print_for_a_person(const DetectArguments& arguments, const Detection& detection) {
  const Findings& findings = detection.findings;
  print("{} finding(s), method {}, {} + {} frames\n", findings.findings.size(), findings.method,
        findings.initial_frames, findings.final_frames);
  if (!findings.findings.empty()) {
    print("{:>4}  {:7}  {:>20}  {:>8}  {:>9}  {:>11}  {:>8}\n", "id", "kind", "box x y w h (px)", "area px",
          "height mm", "distance m", "score");
  }
  for (const Finding& finding : findings.findings) {
    const Box& box = finding.box;
    print("{:>4}  {:7}  {:>20}  {:>8}  {:>9}  {:>11}  {:>8}\n", finding.id,
          finding.kind == ChangeKind::added ? "added" : "removed",
          fmt::format("{} {} {} {}", box.x, box.y, box.width, box.height), finding.pixels.size(),
          or_none("{:.1f}", finding.height_mm),
          or_none("{:.2f}", finding.position_m ? std::optional(finding.position_m->z()) : std::nullopt),
          or_none("{:.1f}", finding.score));
  }
  const Coverage& coverage = findings.coverage;
  print("compared {:.1f} % of the view; not seen before {:.1f} %, no measurement {:.1f} %",
        100.0 * coverage.compared, 100.0 * coverage.unseen, 100.0 * coverage.invalid);
  if (coverage.beyond_clip) print(", too far {:.1f} %", 100.0 * *coverage.beyond_clip);
  print("\n");
  if (detection.level_of_detection) print_levels(detection.level_of_detection->summary);
  print("{}\n", arguments.out);
}

std::vector<std::string> flags_without_a_say(std::string_view method) {
  if (method == octree) return {"--threshold", "--clip", "--sigmas", "--frames", "--false-findings"};
  std::vector<std::string> flags{"--threshold", "--clip", "--sigmas"};
  if (method == name_of(StaticMethod::constant)) flags = {"--sigmas", "--frames", "--false-findings"};
  if (method == name_of(StaticMethod::gaussian)) flags = {"--threshold", "--clip", "--false-findings"};
  OctreeOptions::describe(OctreeOptions{}, [&](const auto& /*value*/, const OptionField& field) {
    flags.push_back(fmt::format("--{}", field.name));
  });
  return flags;
}

// Options of the other methods, given all the same: the person believes that they do something.
std::vector<std::string> options_without_a_say(const CLI::App& command, std::string_view method) {
  std::vector<std::string> warnings;
  for (const std::string& flag : flags_without_a_say(method)) {
    if (command.get_option(flag)->count() == 0) continue;
    warnings.push_back(fmt::format("{} has no say in --method {}", flag, method));
  }
  return warnings;
}

struct Sides {
  Captures initial;
  Captures final;
};

Captures open_side(const std::string& one, const std::vector<std::string>& many,
                   const CaptureOptions& options) {
  Captures side;
  if (many.empty()) side.push_back(open_capture(one, options));
  for (const std::string& path : many) side.push_back(open_capture(path, options));
  return side;
}

Sides open_sides(const DetectArguments& arguments) {
  const CaptureOptions options = arguments.captures.options();
  return {open_side(arguments.initial, arguments.initial_side, options),
          open_side(arguments.final, arguments.final_side, options)};
}

void check_sides(const DetectArguments& arguments) {
  const bool pair = !arguments.initial.empty() || !arguments.final.empty();
  const bool sides = !arguments.initial_side.empty() || !arguments.final_side.empty();
  const bool complete = pair ? !arguments.initial.empty() && !arguments.final.empty()
                             : !arguments.initial_side.empty() && !arguments.final_side.empty();
  if (pair == sides || !complete)
    throw UsageError("captures", "one before and one after the work are needed",
                     "give INITIAL FINAL, or --initial C ... --final C ... for several a side");
}

// A camera that stood still is compared pixel by pixel; any other by the space that it saw through.
std::string method_for(const Sides& sides) {
  const bool several = sides.initial.size() + sides.final.size() > 2;
  const bool moved = poses_differ(sides.initial.front()->info(), sides.final.front()->info());
  return std::string(several || moved ? spatial : name_of(StaticMethod::calibrated));
}

// The static methods compare pixels: of an exact return, to the same angles on the same base.
const Capture& same_view(const Captures& initial, const Capture& final) {
  const auto returned = std::ranges::find_if(
      initial, [&](const auto& capture) { return !poses_differ(capture->info(), final.info()); });
  if (returned == initial.end())
    throw Error("initial captures", "none was taken from where the first final capture was",
                "use --method spatial");
  return **returned;
}

Detection detect_with_one_a_side(const std::string& method, const DetectArguments& arguments,
                                 const Sides& sides, bool several) {
  const Capture& final = *sides.final.front();
  if (method == octree)
    return detect_by_octree(*sides.initial.front(), final, arguments.octree, arguments.detection.regions,
                            terminal_progress());
  StaticDetectionOptions options = arguments.detection;
  options.method = *std::ranges::find(static_methods, method, [](StaticMethod of) { return name_of(of); });
  const Capture& initial = several ? same_view(sides.initial, final) : *sides.initial.front();
  return detect_static(initial, final, options, terminal_progress());
}

Detection detect_by(const std::string& method, const DetectArguments& arguments, const Sides& sides,
                    std::optional<Registration>& registration) {
  if (method == spatial) {
    SpatialDetection spatially = detect_spatial(
        sides.initial, sides.final,
        {arguments.detection.frames, arguments.detection.calibrated, arguments.detection.regions},
        terminal_progress());
    registration = std::move(spatially.registration);
    return std::move(spatially.detection);
  }
  const bool several = sides.initial.size() + sides.final.size() > 2;
  Detection detection = detect_with_one_a_side(method, arguments, sides, several);
  if (several)
    detection.warnings.push_back(
        fmt::format("--method {} compared one capture of each side: the others had no say", method));
  return detection;
}

// Warnings come last, so that a failure is one line.
int detect(const DetectArguments& arguments, const CLI::App& command) {
  check_sides(arguments);
  check_options(arguments.detection);
  check_options(arguments.octree);
  OutputFolder out(
      arguments.out,
      {"detections.json", "changes.png", "overlay.png", "depth_overlay.png", "level_of_detection.png",
       "level_of_detection.json", "registration.json", "changed_points.png"},
      arguments.overwrite ? Existing::replace : Existing::refuse);
  const Sides sides = open_sides(arguments);
  const std::string method = arguments.method.empty() ? method_for(sides) : arguments.method;
  std::optional<Registration> registration;
  const Detection detection = detect_by(method, arguments, sides, registration);
  std::vector<std::string> warnings = options_without_a_say(command, method);
  warnings.insert(warnings.end(), detection.warnings.begin(), detection.warnings.end());

  const std::string json = to_json(detection.findings);
  write_file(out.path("changes.png"), encode_png(detection.changed));
  write_file(out.path("depth_overlay.png"),
             encode_png(draw_on_depth(detection.final_m, detection.findings.findings)));
  write_color_overlay(*sides.final.front(), detection, out, warnings);
  if (method == octree && sides.final.front()->color_frames() > 0)
    write_file(out.path("changed_points.png"),
               encode_png(draw_changed_points(sides.final.front()->color(0), detection.changed,
                                              detection.final_m, sides.final.front()->info())));
  if (registration) write_file(out.path("registration.json"), to_json(*registration));
  if (const auto& level = detection.level_of_detection) {
    write_file(out.path("level_of_detection.png"), encode_png(draw_level_of_detection(level->least_mm)));
    write_file(out.path("level_of_detection.json"), to_json(level->summary));
  }
  write_file(out.path("detections.json"), json);
  out.commit();
  for (const std::string& warning : warnings) fmt::print(stderr, "rva: warning: {}\n", warning);

  if (arguments.json) {
    print("{}", json);
  } else {
    print_for_a_person(arguments, detection);
  }
  return arguments.fail_on_detection && !detection.findings.findings.empty() ? status_detected : 0;
}

}  // namespace

void add_detect_command(CLI::App& program, Outcome& outcome) {
  CLI::App& command =
      *program.add_subcommand("detect", "finds what changed between two captures of one scene");
  const auto arguments = std::make_shared<DetectArguments>();
  command.add_option("INITIAL", arguments->initial, "capture before the work");
  command.add_option("FINAL", arguments->final, "capture after the work");
  command.add_option("--initial", arguments->initial_side, "captures before the work, from nearly one place")
      ->type_name("CAPTURE");
  command
      .add_option("--final", arguments->final_side,
                  "captures after the work; results are in the first one's view")
      ->type_name("CAPTURE");
  command.add_option("--out", arguments->out, "folder for the result")->required()->type_name("DIR");
  command
      .add_option(
          "--method", arguments->method,
          "how captures are compared; without it spatial where their poses differ or a side has several, "
          "else calibrated")
      ->check(CLI::IsMember(method_names()));
  add_flags(command, arguments->detection);
  add_flags(command, arguments->octree);
  arguments->captures.add_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier result in DIR");
  command.add_flag("--json", arguments->json, "print detections.json instead of a table");
  command.add_flag("--fail-on-detection", arguments->fail_on_detection,
                   "exit with status 3 when something was found");
  command.callback([arguments, &outcome, &command] { outcome.status = detect(*arguments, command); });
}

}  // namespace rva::cli
