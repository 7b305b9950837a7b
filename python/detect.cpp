#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "classify/naming_model.hpp"
#include "core/enum_names.hpp"
#include "core/file_origin.hpp"
#include "core/path_text.hpp"
#include "detect/findings/loose_parts.hpp"
#include "detect/genuine_captures.hpp"
#include "detect/provenance.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "detect/result_folder.hpp"
#include "detection.hpp"
#include "keywords.hpp"
#include "long_call.hpp"
#include "module.hpp"
#include "plan/plan_match.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

struct DetectArguments {
  std::optional<std::filesystem::path> out{};
  bool overwrite = false;
  std::string method{name_of(DetectionMethod::automatic)};
  std::vector<std::filesystem::path> ignore{};
  std::vector<std::array<int, 4>> within{};
  std::optional<std::filesystem::path> plan{};
  DetectOptions detection{};
  PlanOptions planned{};
  bool shake = false;
  LoosePartOptions loose{};
  bool classify = false;
  std::optional<std::filesystem::path> classifier{};
  std::optional<std::filesystem::path> model{};
  std::optional<std::filesystem::path> labels{};
  ModelOptions of_model{};
  CaptureArguments captures{};
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("out", self.out, "folder for the result, as rva detect writes it; None for no folder");
    visit("overwrite", self.overwrite, "replace an earlier result in out");
    visit("method", self.method,
          "how captures are compared: auto, constant, gaussian, calibrated, spatial or octree");
    visit("ignore", self.ignore,
          "pictures or files of polygons of what is left out, in pixels of the first initial depth image");
    visit("within", self.within, "rectangles x, y, width, height outside which everything is left out");
    visit("plan", self.plan, "file of the parts that the work order states");
    visit_options(self.detection, visit);
    visit_options(self.planned, visit);
    visit("shake", self.shake,
          "the structure was rocked or tapped between the captures, and nothing else was done: findings that "
          "one loose part left by moving are stated together");
    visit_options(self.loose, visit);
    visit("classify", self.classify, "state what each finding may be, by the classifier that comes with RVA");
    visit("classifier", self.classifier, "the same by a classifier of your own: its card, beside its model");
    visit("model", self.model, "the same by an object detector, YOLO or SSD; it needs labels");
    visit("labels", self.labels, "file with the names of the model's classes, one a line");
    visit_options(self.of_model, visit);
    CaptureArguments::describe_keywords(self.captures, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

DetectOptions options_of(const DetectArguments& arguments) {
  DetectOptions options = arguments.detection;
  const std::optional<DetectionMethod> method = value_of<DetectionMethod>(arguments.method);
  if (!method) {
    std::string names;
    for (const std::string_view name : names_of<DetectionMethod>())
      names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
    throw UsageError("method", fmt::format("there is no {}", printable(arguments.method)), "give " + names);
  }
  options.method = *method;
  return options;
}

NamingChoice naming_of(const DetectArguments& arguments) {
  if (int{arguments.classify} + int{arguments.classifier.has_value()} + int{arguments.model.has_value()} > 1)
    throw UsageError("model", "findings are named by one model", "give classify, classifier or model");
  if (arguments.model.has_value() != arguments.labels.has_value())
    throw UsageError("labels", "a model needs labels, and labels a model", "give both or none");
  const auto text = [](const auto& path) { return path ? path->string() : std::string(); };
  return {.classify = arguments.classify,
          .classifier = text(arguments.classifier),
          .model = text(arguments.model),
          .labels = text(arguments.labels),
          .options = arguments.of_model};
}

Mask left_out(const DetectArguments& arguments, const CaptureInfo& initial) {
  const int width = initial.depth.width;
  const int height = initial.depth.height;
  IgnoredRegions regions;
  for (const auto& [x, y, box_width, box_height] : arguments.within)
    add_within(regions, {x, y, box_width, box_height}, width, height);
  Mask mask = mask_of(regions, width, height);
  for (const std::filesystem::path& file : arguments.ignore)
    unite(mask, read_ignored_mask(file, width, height));
  return mask;
}

// Warnings of arguments that belong to other methods, which the user expects to have an effect.
std::vector<std::string> without_effect(const std::set<std::string>& given, const std::string& method) {
  const std::vector<std::string> used = options_of(value_of<DetectionMethod>(method).value());
  std::vector<std::string> warnings;
  DetectOptions::describe(DetectOptions{}, [&](const auto& /*value*/, const OptionField& field) {
    const std::string name = keyword_name(field.name);
    if (given.contains(name) && std::ranges::find(used, field.name) == used.end())
      warnings.push_back(fmt::format("{} has no effect with method='{}'", name, method));
  });
  return warnings;
}

void check_shake(const DetectArguments& arguments, DetectionMethod method) {
  check_options(arguments.loose);
  if (!arguments.shake) return;
  if (arguments.plan)
    throw UsageError("shake", "nothing is planned in a shake test", "give shake or plan, not both");
  if (!shows_both_ends(method))
    throw UsageError("shake", fmt::format("{} shows only what came nearer", arguments.method),
                     "leave out method, or give calibrated or spatial");
}

void compare_with_plan(const Plan& plan, const PlanOptions& options, const CaptureInfo& initial,
                       DetectionResult& result) {
  const PlanMatch match =
      match_plan(plan, result.sides.detection, {initial.depth, result.final->capture->info().depth}, options);
  add_plan(match, result.json);
  result.plan = json_of(match);
}

// The work of `rva detect`, in the same order, so that failures are the same.
std::shared_ptr<DetectionResult> compare(const CaptureSide& before, const CaptureSide& after,
                                         const DetectArguments& arguments,
                                         const std::set<std::string>& given) {
  const DetectOptions options = options_of(arguments);
  check_options(options);
  check_options(arguments.planned);
  check_shake(arguments, options.method);
  const std::optional<Plan> plan = arguments.plan ? std::optional(read_plan(*arguments.plan)) : std::nullopt;
  NamingModel model(naming_of(arguments));
  std::optional<OutputFolder> out;
  if (arguments.out)
    out.emplace(*arguments.out, result_files(), arguments.overwrite ? Existing::replace : Existing::refuse);
  const Captures initial = before.captures();
  const Captures final = after.captures();
  require_distinct(before.paths(), after.paths());
  const Provenance provenance{time_of_making(), sources_of(before.paths(), initial),
                              sources_of(after.paths(), final)};
  const CaptureInfo& initial_info = initial.front()->info();
  auto result = std::make_shared<DetectionResult>(
      DetectionResult{.sides = rva::detect(initial, final, options, progress_to(arguments.progress),
                                           left_out(arguments, initial_info)),
                      .final = after.owners.front()});
  const Detection& detection = result->sides.detection;
  result->warnings = without_effect(given, detection.findings.method);
  std::ranges::copy(detection.warnings, std::back_inserter(result->warnings));
  result->json = detections_json(detection.findings, provenance);
  if (plan) compare_with_plan(*plan, arguments.planned, initial_info, *result);
  if (arguments.shake)
    add_loose_parts(find_loose_parts(detection, final.front()->info().depth, arguments.loose), result->json);
  result->classes = model.name_findings(detection, *final.front(), result->json, result->warnings);
  if (out) {
    std::ranges::move(write(*result, *out), std::back_inserter(result->warnings));
    out->commit();
  }
  return result;
}

std::shared_ptr<DetectionResult> detect(py::handle before, py::handle after, const py::kwargs& given) {
  DetectArguments arguments;
  const std::set<std::string> names = take("detect", given, arguments);
  const CaptureSide initial = side_from(before, arguments.captures, "before");
  const CaptureSide final = side_from(after, arguments.captures, "after");
  return without_lock([&] { return compare(initial, final, arguments, names); });
}

}  // namespace

void add_detect(py::module_& module) {
  const auto text = description<DetectArguments>(
      "detect", "before, after",
      "Finds what changed between captures of one scene, as rva detect does. Either side is a path, a "
      "Capture, "
      "or a list of several from nearly one pose; findings are in the view of the first one after the work.");
  module.def("detect", detect, py::arg("before"), py::arg("after"), text.c_str());
}

}  // namespace rva::python
