#include <fmt/format.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "classify/finding_classes.hpp"
#include "cli/commands.hpp"
#include "cli/finding_names.hpp"
#include "cli/option_flags.hpp"
#include "cli/plan_printing.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "detect/detect.hpp"
#include "detect/findings/loose_parts.hpp"
#include "detect/genuine_captures.hpp"
#include "detect/provenance.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "detect/result_folder.hpp"
#include "plan/plan_match.hpp"

namespace rva::cli {
namespace {

struct DetectArguments {
  std::string initial;
  std::string final;
  std::vector<std::string> initial_side;
  std::vector<std::string> final_side;
  std::string out;
  CaptureFlags captures;
  std::string method{name_of(DetectionMethod::automatic)};
  DetectOptions detection;
  std::vector<std::string> ignore;
  std::vector<std::string> within;
  std::string plan;
  PlanOptions planned;
  bool shake = false;
  LoosePartOptions loose;
  NamingFlags naming;
  bool overwrite = false;
  bool json = false;
  bool fail_on_detection = false;
};

void print_levels(const DetectionLevelSummary& summary) {
  print(
      "judged {:.1f} % of the view; there, what the depth image shows as wide as stated would have been "
      "found from this height:\n",
      100.0 * summary.judged);
  // At distances with fewer pixels, most are wrong matches; level_of_detection.json has them.
  constexpr std::size_t fewest_of_all = 500;
  std::size_t all = 0;
  for (const DetectionLevels& levels : summary.by_distance) all += levels.pixels;
  for (const DetectionLevels& levels : summary.by_distance) {
    if (levels.pixels * fewest_of_all < all) continue;
    print("{:>9.1f}-{:.1f} m: {:.1f} mm in half of it, {:.1f} mm in nine tenths, {:.0f} mm wide\n",
          levels.from_m, levels.to_m, levels.median_mm, levels.p90_mm, levels.width_mm.value_or(0.0));
  }
  std::string shares;
  for (const FindableShare& findable : summary.findable)
    shares += shares.empty()
                  ? fmt::format("{:.0f} % inspected for objects from {:.0f} mm up", 100.0 * findable.share,
                                findable.size_mm)
                  : fmt::format(", {:.0f} % from {:.0f} mm", 100.0 * findable.share, findable.size_mm);
  print("{}\n", shares);
}

// A value that the method does not provide is printed as a dash.
std::string or_none(const char* format, std::optional<double> number) {
  return number ? fmt::format(fmt::runtime(format), *number) : "-";
}

void print_table(const Findings& findings) {
  if (!findings.findings.empty()) {
    print("{:>4}  {:10}  {:>20}  {:>8}  {:>9}  {:>11}  {:>8}\n", "id", "kind", "box x y w h (px)", "area px",
          "height mm", "distance m", "score");
  }
  for (const Finding& finding : findings.findings) {
    const Box& box = finding.box;
    print("{:>4}  {:10}  {:>20}  {:>8}  {:>9}  {:>11}  {:>8}\n", finding.id, name_of(finding.kind),
          fmt::format("{} {} {} {}", box.x, box.y, box.width, box.height), finding.pixels.size(),
          or_none("{:.1f}", finding.height_mm),
          or_none("{:.2f}", finding.position_m ? std::optional(finding.position_m->z()) : std::nullopt),
          or_none("{:.1f}", finding.score));
  }
  for (const Finding& finding : findings.findings) {
    if (finding.moved_from)
      print("finding {} has about the size of {}, which was removed: it may be the same object, moved\n",
            finding.id, *finding.moved_from);
  }
}

// Where nothing else was done, any finding may be something that moved, whether or not its counterpart shows.
void print_loose_parts(const std::vector<LoosePart>& parts, std::size_t findings) {
  for (const LoosePart& part : parts)
    print(
        "loose part: moved {}, by at most {:.0f} mm, {:.0f} x {:.0f} mm in the image (findings {} and {})\n",
        direction_of(part), part.moved_at_most_mm(), part.size_mm[0], part.size_mm[1], part.added,
        part.removed);
  if (findings > 2 * parts.size())
    print("{} finding(s) without a counterpart: something may have moved there, too\n",
          findings - 2 * parts.size());
}

// @param final the camera of the first final capture
// @param match findings compared with a plan, if there is one
void print_for_a_person(const DetectArguments& arguments, const Detection& detection, const Intrinsics& final,
                        const std::optional<PlanMatch>& match, const std::vector<LoosePart>& loose,
                        const std::optional<FindingClasses>& classes) {
  const Findings& findings = detection.findings;
  print("{} finding(s), method {}, {} + {} frames\n", findings.findings.size(), findings.method,
        findings.initial_frames, findings.final_frames);
  if (match)
    print_plan(*match, findings.findings);
  else
    print_table(findings);
  if (arguments.shake) print_loose_parts(loose, findings.findings.size());
  if (classes) print_classes(*classes, match);
  const Coverage& coverage = findings.coverage;
  print("compared {:.1f} % of the view; not seen before {:.1f} %, no measurement {:.1f} %",
        100.0 * coverage.compared, 100.0 * coverage.unseen, 100.0 * coverage.invalid);
  if (coverage.beyond_clip) print(", too far {:.1f} %", 100.0 * *coverage.beyond_clip);
  if (coverage.left_out) print(", left out as asked {:.1f} %", 100.0 * *coverage.left_out);
  print("\n");
  if (detection.level_of_detection) print_levels(level_summary(detection, final));
  print("{}\n", arguments.out);
}

// Warnings of options that belong to other methods, which the user expects to have an effect.
std::vector<std::string> options_without_effect(const CLI::App& command, DetectionMethod method) {
  const std::vector<std::string> used = options_of(method);
  std::vector<std::string> warnings;
  DetectOptions::describe(DetectOptions{}, [&](const auto& /*value*/, const OptionField& field) {
    const std::string flag = fmt::format("--{}", field.name);
    if (std::ranges::find(used, field.name) == used.end() && command.get_option(flag)->count() > 0)
      warnings.push_back(fmt::format("{} has no effect with --method {}", flag, name_of(method)));
  });
  return warnings;
}

struct Sides {
  Captures initial;
  Captures final;
  Provenance provenance;
};

std::vector<std::filesystem::path> paths_of(const std::string& one, const std::vector<std::string>& many) {
  if (many.empty()) return {one};
  return {many.begin(), many.end()};
}

Captures open_side(const std::vector<std::filesystem::path>& paths, const CaptureOptions& options) {
  Captures side;
  for (const std::filesystem::path& path : paths) side.push_back(open_capture(path, options));
  return side;
}

Sides open_sides(const DetectArguments& arguments) {
  const CaptureOptions options = arguments.captures.options();
  const auto initial = paths_of(arguments.initial, arguments.initial_side);
  const auto final = paths_of(arguments.final, arguments.final_side);
  Sides sides{open_side(initial, options), open_side(final, options), {time_of_making(), {}, {}}};
  require_distinct(initial, final);
  sides.provenance.initial = sources_of(initial, sides.initial);
  sides.provenance.final = sources_of(final, sides.final);
  return sides;
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

// Parses "x,y,w,h", each at most a million in magnitude.
Box box_from(const std::string& text) {
  std::array<int, 4> numbers{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [rest, failure] = std::from_chars(at, end, numbers.at(i));
    const bool last = i + 1 == numbers.size();
    constexpr int most = 1'000'000;
    if (numbers.at(i) < -most || numbers.at(i) > most || failure != std::errc{} ||
        (last ? rest != end : rest == end || *rest != ','))
      throw UsageError("--within", fmt::format("{} is not a rectangle", printable(text)),
                       "give x,y,w,h in pixels");
    at = rest + 1;
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Mask left_out(const DetectArguments& arguments, const CaptureInfo& initial) {
  const int width = initial.depth.width;
  const int height = initial.depth.height;
  IgnoredRegions regions;
  for (const std::string& text : arguments.within) add_within(regions, box_from(text), width, height);
  Mask mask = mask_of(regions, width, height);
  for (const std::string& file : arguments.ignore) unite(mask, read_ignored_mask(file, width, height));
  return mask;
}

void check_shake(const DetectArguments& arguments) {
  check_options(arguments.loose);
  if (arguments.shake && !shows_both_ends(value_of<DetectionMethod>(arguments.method).value()))
    throw UsageError(
        "--shake",
        fmt::format("has no meaning with --method {}, which shows only what came nearer", arguments.method),
        "leave out --method, or use calibrated or spatial");
}

// Warnings come last, so that a failure is one line.
int detect(const DetectArguments& arguments, const CLI::App& command) {
  check_sides(arguments);
  check_options(arguments.detection);
  check_options(arguments.planned);
  check_shake(arguments);
  const std::optional<Plan> plan =
      arguments.plan.empty() ? std::nullopt : std::optional(read_plan(arguments.plan));
  NamingModel model(arguments.naming);
  OutputFolder out(arguments.out, result_files(), arguments.overwrite ? Existing::replace : Existing::refuse);
  const Sides sides = open_sides(arguments);
  DetectOptions options = arguments.detection;
  options.method = value_of<DetectionMethod>(arguments.method).value();
  const SidesDetection result = detect(sides.initial, sides.final, options, terminal_progress(),
                                       left_out(arguments, sides.initial.front()->info()));
  const Detection& detection = result.detection;
  std::vector<std::string> warnings =
      options_without_effect(command, value_of<DetectionMethod>(detection.findings.method).value());
  std::ranges::copy(detection.warnings, std::back_inserter(warnings));
  nlohmann::ordered_json json = detections_json(detection.findings, sides.provenance);
  const Intrinsics final_camera = sides.final.front()->info().depth;
  std::optional<PlanMatch> match;
  if (plan) {
    match =
        match_plan(*plan, detection, {sides.initial.front()->info().depth, final_camera}, arguments.planned);
    add_plan(*match, json);
    write_file(out.path(result_file::plan), json_file_text(json_of(*match)));
  }
  std::vector<LoosePart> loose;
  if (arguments.shake) {
    loose = find_loose_parts(detection, final_camera, arguments.loose);
    add_loose_parts(loose, json);
  }
  const auto classes = model.name_findings(detection, *sides.final.front(), json, warnings);
  std::ranges::move(write_result(result, *sides.final.front(), out.path(""), json),
                    std::back_inserter(warnings));
  out.commit();
  for (const std::string& warning : warnings) fmt::print(stderr, "rva: warning: {}\n", warning);

  if (arguments.json) {
    print("{}", json_file_text(json));
  } else {
    print_for_a_person(arguments, detection, final_camera, match, loose, classes);
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
  command.add_option("--initial", arguments->initial_side, "captures before the work, from nearly one pose")
      ->type_name("CAPTURE");
  command
      .add_option("--final", arguments->final_side,
                  "captures after the work; results are in the first one's view")
      ->type_name("CAPTURE");
  command.add_option("--out", arguments->out, "folder for the result")->required()->type_name("DIR");
  command
      .add_option("--method", arguments->method,
                  "how captures are compared; auto checks from the depth images whether the camera moved: "
                  "calibrated where it did not, else spatial")
      ->check(name_among<DetectionMethod>())
      ->capture_default_str();
  command
      .add_option(
          "--ignore", arguments->ignore,
          "leave out what a mask or a file of polygons shows, in pixels of the first initial depth image")
      ->type_name("MASK.png|REGIONS.json")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--within", arguments->within, "leave out everything but this rectangle; may be repeated")
      ->type_name("x,y,w,h")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* const plan =
      command
          .add_option(
              "--plan", arguments->plan,
              "the parts that the work order states: findings of them are grouped, and what is missing, "
              "surplus or not planned is listed")
          ->type_name("PLAN.yaml");
  add_flags(command, arguments->detection);
  add_flags(command, arguments->planned);
  PlanOptions::describe(arguments->planned, [&](const auto& /*value*/, const OptionField& field) {
    command.get_option(fmt::format("--{}", field.name))->needs(plan);
  });
  CLI::Option* const shake =
      command
          .add_flag("--shake", arguments->shake,
                    "the structure was rocked or tapped between the captures, and nothing else was done: "
                    "findings that one loose part left by moving are stated together")
          ->excludes(plan);
  add_flags(command, arguments->loose);
  LoosePartOptions::describe(arguments->loose, [&](const auto& /*value*/, const OptionField& field) {
    command.get_option(fmt::format("--{}", field.name))->needs(shake);
  });
  arguments->naming.add_to(command);
  arguments->captures.add_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier result in DIR");
  command.add_flag("--json", arguments->json, "print detections.json instead of a table");
  command.add_flag("--fail-on-detection", arguments->fail_on_detection,
                   "exit with status 3 when something was found");
  command.callback([arguments, &outcome, &command] { outcome.status = detect(*arguments, command); });
}

}  // namespace rva::cli
