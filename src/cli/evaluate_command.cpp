#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/random.hpp"
#include "evaluate/evaluation_json.hpp"
#include "evaluate/moved_report.hpp"
#include "evaluate/recorded_study.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"

namespace rva::cli {
namespace {

struct EvaluateArguments {
  std::string out;
  std::string scene;
  std::string recorded;
  StudyOptions study;
  bool moved = false;
  bool octree = false;
  bool lamp = false;
  bool color = false;
  PoseReturnOptions pose_return;
  std::string how{name_of(CameraReturn::elsewhere)};
  std::vector<int> captures{MovedStudyOptions{}.captures};
  std::vector<double> allowed{MovedStudyOptions{}.allowed};
  std::string cameras = "d435";
  std::vector<std::string> bay;
  bool overwrite = false;
  bool resume = false;
};

constexpr auto file_name = "evaluation.json";

std::string name_of_bay(const EvaluateArguments& arguments) {
  return fmt::format("{}", fmt::join(arguments.bay, ","));
}

std::vector<SimulatedInspection> earlier(const EvaluateArguments& arguments) {
  const std::filesystem::path file = std::filesystem::path(arguments.out) / file_name;
  if (!arguments.resume || !std::filesystem::exists(file)) return {};
  Evaluation evaluation = evaluation_from_json(read_text_file(file), printable(file));
  if (evaluation.scene != arguments.scene || evaluation.cameras != arguments.cameras ||
      evaluation.bay != name_of_bay(arguments))
    throw UsageError("--resume", "the evaluation that is there is of another scene, bay or camera",
                     "give the options that it was begun with, or another --out");
  return std::move(evaluation.inspections);
}

void evaluate(const EvaluateArguments& arguments) {
  std::optional<Scene> scene;
  if (!arguments.scene.empty()) scene = load_scene(arguments.scene);
  StudyOptions options = arguments.study;
  options.sensor = camera_of_each(arguments.cameras);
  options.bay = bay_features(arguments.bay);
  Existing existing = arguments.overwrite || arguments.resume ? Existing::replace : Existing::refuse;
  (void)OutputFolder(arguments.out, {file_name}, existing);  // refuses at once, not after an inspection
  const auto keep = [&](const std::vector<SimulatedInspection>& inspections) {
    OutputFolder out(arguments.out, {file_name}, existing);
    write_file(out.path(file_name), json_file_text(json_of(Evaluation{arguments.scene, arguments.cameras,
                                                                      name_of_bay(arguments), inspections})));
    out.commit();
    existing = Existing::replace;
  };
  const std::vector<SimulatedInspection> inspections =
      run_study(options, scene, earlier(arguments), terminal_progress(), keep);
  print("{}{}\n", to_table(tally(inspections)), arguments.out);
}

std::vector<MovedInspection> earlier_moved(const EvaluateArguments& arguments,
                                           const std::string& begun_with) {
  const std::filesystem::path file = std::filesystem::path(arguments.out) / file_name;
  if (!arguments.resume || !std::filesystem::exists(file)) return {};
  return moved_inspections_from_json(read_text_file(file), printable(file), begun_with);
}

void evaluate_moved(const EvaluateArguments& arguments) {
  check_options(arguments.study);
  MovedStudyOptions options;
  options.inspections = arguments.study.inspections;
  options.first_seed = arguments.study.first_seed;
  options.captures = arguments.captures;
  options.allowed = arguments.allowed;
  options.how = value_of<CameraReturn>(arguments.how).value();
  options.octree = arguments.octree;
  options.lamp = arguments.lamp;
  options.color = arguments.color;
  options.pose_return = arguments.pose_return;
  check_options(options.pose_return);
  options.sensor = camera_of_each(arguments.cameras);
  options.bay = bay_features(arguments.bay);
  const std::string begun_with = fmt::format(
      "return {}, cameras {}, first seed {}, captures {}, allowed {}{}{}{}{}{}", arguments.how,
      arguments.cameras, options.first_seed, fmt::join(options.captures, ","),
      fmt::join(options.allowed, ","), options.octree ? ", octree" : "", options.lamp ? ", lamp" : "",
      options.color ? ", color" : "", arguments.bay.empty() ? "" : ", bay " + name_of_bay(arguments),
      options.pose_return.approaches > 1
          ? fmt::format(", approaches {} within {} deg", options.pose_return.approaches,
                        options.pose_return.within_deg)
          : "");
  Existing existing = arguments.overwrite || arguments.resume ? Existing::replace : Existing::refuse;
  (void)OutputFolder(arguments.out, {file_name}, existing);  // refuses at once, not after an inspection
  const auto keep = [&](const std::vector<MovedInspection>& inspections) {
    OutputFolder out(arguments.out, {file_name}, existing);
    write_file(out.path(file_name), json_file_text(json_of(inspections, begun_with)));
    out.commit();
    existing = Existing::replace;
  };
  const std::vector<MovedInspection> inspections =
      run_moved_study(options, earlier_moved(arguments, begun_with), terminal_progress(), keep);
  print("{}{}\n", to_table(inspections), arguments.out);
}

void evaluate_recorded(const EvaluateArguments& arguments) {
  OutputFolder out(arguments.out, {file_name}, arguments.overwrite ? Existing::replace : Existing::refuse);
  const std::vector<RecordedInspection> inspections =
      run_recorded_study(arguments.recorded, terminal_progress());
  write_file(out.path(file_name), json_file_text(json_of(inspections)));
  out.commit();
  print("{}{}\n", to_table(inspections), arguments.out);
}

}  // namespace

void add_evaluate_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "evaluate", "measures on simulated inspections how reliably the methods detect");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command.add_option("--out", arguments->out, "folder for evaluation.json")->required()->type_name("DIR");
  CLI::Option* const scene =
      command.add_option("--scene", arguments->scene,
                         "inspect this scene again and again; without it, wings and debris drawn by chance");
  CLI::Option* const frames =
      command.add_option("--frames", arguments->study.frames, "depth frames of either capture, ascending")
          ->delimiter(',')
          ->type_name("N,N...")
          ->capture_default_str();
  add_flags(command, arguments->study);
  CLI::Option* const overwrite =
      command.add_flag("--overwrite", arguments->overwrite, "replace an earlier evaluation in DIR");
  CLI::Option* const resume =
      command.add_flag("--resume", arguments->resume, "go on with an evaluation in DIR that was interrupted")
          ->excludes(overwrite);
  CLI::Option* const moved = command
                                 .add_flag("--moved", arguments->moved,
                                           "spatial, with a camera that came back, instead of the "
                                           "static methods; 10 frames a capture")
                                 ->excludes(frames)
                                 ->excludes(scene);
  command.add_option("--captures", arguments->captures, "--moved: dithered captures a side, ascending")
      ->delimiter(',')
      ->type_name("M,M...")
      ->capture_default_str()
      ->needs(moved);
  command
      .add_option("--allowed", arguments->allowed, "--moved: false findings allowed an inspection, ascending")
      ->delimiter(',')
      ->type_name("X,X...")
      ->capture_default_str()
      ->needs(moved);
  command
      .add_option(
          "--return", arguments->how,
          "--moved: where the camera came back to: elsewhere (the robot was lifted out), near (one or "
          "two servo steps off), exact, rest (as the console's robot: within half a step)")
      ->check(name_among<CameraReturn>())
      ->type_name("WHERE")
      ->capture_default_str()
      ->needs(moved);
  command
      .add_option("--cameras", arguments->cameras,
                  "random:SEED or imperfect:SEED draws a camera by chance for each inspection; or the name "
                  "of a model, as of rva "
                  "simulate --camera-model")
      ->type_name("MODEL")
      ->capture_default_str();
  command
      .add_option(
          "--bay", arguments->bay,
          fmt::format("makes bays drawn by chance harder: {}, or all", fmt::join(bay_feature_names(), ", ")))
      ->delimiter(',')
      ->type_name("WHAT,...")
      ->excludes(scene);
  command.add_flag("--lamp", arguments->lamp, "--moved: images under the camera's lamp, too")->needs(moved);
  command.add_flag("--color", arguments->color, "--moved: colour images, too")->needs(moved);
  add_flags(command, arguments->pose_return);
  command.add_flag("--with-octree", arguments->octree, "--moved: the thesis' pipeline too, a minute a pair")
      ->needs(moved);
  command
      .add_option("--recorded", arguments->recorded,
                  "captures of any camera with the truth beside them, instead of simulated inspections")
      ->type_name("FOLDER")
      ->excludes(frames)
      ->excludes(scene)
      ->excludes(resume)
      ->excludes(moved);
  command.callback([arguments] {
    if (!arguments->recorded.empty()) return evaluate_recorded(*arguments);
    arguments->moved ? evaluate_moved(*arguments) : evaluate(*arguments);
  });
}

}  // namespace rva::cli
