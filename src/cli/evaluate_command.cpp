#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/output_folder.hpp"
#include "evaluate/moved_report.hpp"
#include "evaluate/planned_study.hpp"
#include "evaluate/recorded_study.hpp"
#include "evaluate/report.hpp"
#include "evaluate/shake_study.hpp"
#include "evaluate/study_folder.hpp"
#include "sim/sensor/camera_models.hpp"

namespace rva::cli {
namespace {

struct EvaluateArguments {
  std::string out;
  StudySubject subject;
  std::string recorded;
  bool planned = false;
  std::string shake;
  StudyOptions study;
  bool moved = false;
  MovedStudyOptions moved_study;
  std::string how{name_of(CameraReturn::elsewhere)};
  bool overwrite = false;
  bool resume = false;
};

StudyFolder folder_of(const EvaluateArguments& arguments) {
  return {.path = arguments.out, .overwrite = arguments.overwrite, .resume = arguments.resume};
}

void evaluate(const EvaluateArguments& arguments) {
  const std::vector<SimulatedInspection> inspections =
      run_study_in(folder_of(arguments), arguments.study, arguments.subject, terminal_progress());
  print("{}{}\n", to_table(tally(inspections)), arguments.out);
}

void evaluate_moved(const EvaluateArguments& arguments) {
  check_options(arguments.study);
  MovedStudyOptions options = arguments.moved_study;
  options.inspections = arguments.study.inspections;
  options.first_seed = arguments.study.first_seed;
  options.how = value_of<CameraReturn>(arguments.how).value();
  const std::vector<MovedInspection> inspections =
      run_moved_study_in(folder_of(arguments), options, arguments.subject, terminal_progress());
  print("{}{}\n", to_table(inspections), arguments.out);
}

void evaluate_recorded(const EvaluateArguments& arguments) {
  OutputFolder out(arguments.out, {evaluation_file},
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const std::vector<RecordedInspection> inspections =
      run_recorded_study(arguments.recorded, terminal_progress());
  write_evaluation(json_of(inspections), arguments.recorded, out);
  out.commit();
  print("{}{}\n", to_table(inspections), arguments.out);
}

void evaluate_planned(const EvaluateArguments& arguments) {
  StudyOptions options = arguments.study;
  options.sensor = camera_of_each(arguments.subject.cameras);
  check_options(options);
  OutputFolder out(arguments.out, {evaluation_file},
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const std::vector<PlannedInspection> inspections = run_planned_study(options, terminal_progress());
  nlohmann::ordered_json json = json_of(inspections);
  json["cameras"] = arguments.subject.cameras;
  write_evaluation(std::move(json), "", out);
  out.commit();
  print("{}{}\n", to_table(inspections), arguments.out);
}

void evaluate_shake(const EvaluateArguments& arguments) {
  StudyOptions options = arguments.study;
  options.sensor = camera_of_each(arguments.subject.cameras);
  check_options(options);
  const Shaken shaken = value_of<Shaken>(arguments.shake).value();
  OutputFolder out(arguments.out, {evaluation_file},
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const std::vector<ShakeInspection> inspections = run_shake_study(options, shaken, terminal_progress());
  nlohmann::ordered_json json = json_of(inspections, shaken);
  json["cameras"] = arguments.subject.cameras;
  write_evaluation(std::move(json), "", out);
  out.commit();
  print("{}{}\n", to_table(inspections, shaken), arguments.out);
}

}  // namespace

void add_evaluate_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "evaluate", "measures on simulated inspections how reliably the methods detect");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command.add_option("--out", arguments->out, "folder for evaluation.json")->required()->type_name("DIR");
  CLI::Option* const scene =
      command.add_option("--scene", arguments->subject.scene,
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
  command
      .add_option("--captures", arguments->moved_study.captures,
                  "--moved: dithered captures a side, ascending")
      ->delimiter(',')
      ->type_name("M,M...")
      ->capture_default_str()
      ->needs(moved);
  command
      .add_option("--allowed", arguments->moved_study.allowed,
                  "--moved: false findings allowed an inspection, ascending")
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
      .add_option("--cameras", arguments->subject.cameras,
                  "random:SEED or imperfect:SEED draws a camera by chance for each inspection; or the name "
                  "of a model, as of rva "
                  "simulate --camera-model")
      ->type_name("MODEL")
      ->capture_default_str();
  CLI::Option* const bay = command
                               .add_option("--bay", arguments->subject.bay,
                                           fmt::format("makes bays drawn by chance harder: {}, or all",
                                                       fmt::join(bay_feature_names(), ", ")))
                               ->delimiter(',')
                               ->type_name("WHAT,...")
                               ->excludes(scene);
  command.add_flag("--lamp", arguments->moved_study.lamp, "--moved: images under the camera's lamp, too")
      ->needs(moved);
  command.add_flag("--color", arguments->moved_study.color, "--moved: colour images, too")->needs(moved);
  add_flags(command, arguments->moved_study.pose_return);
  command
      .add_flag("--with-octree", arguments->moved_study.octree,
                "--moved: the thesis' pipeline too, a minute a pair")
      ->needs(moved);
  CLI::Option* const recorded =
      command
          .add_option("--recorded", arguments->recorded,
                      "captures of any camera with the truth beside them, instead of simulated inspections")
          ->type_name("FOLDER")
          ->excludes(frames)
          ->excludes(scene)
          ->excludes(resume)
          ->excludes(moved);
  CLI::Option* const planned =
      command
          .add_flag(
              "--planned", arguments->planned,
              "planned work with one missing part and one lost object, grouped by a plan; 4 captures a side")
          ->excludes(frames)
          ->excludes(scene)
          ->excludes(resume)
          ->excludes(moved)
          ->excludes(bay)
          ->excludes(recorded);
  command
      .add_option("--shake", arguments->shake,
                  "shake tests, in which a loose part moved by 5 mm or nothing did; 1 capture a side")
      ->check(name_among<Shaken>())
      ->type_name("MOVED")
      ->excludes(frames)
      ->excludes(scene)
      ->excludes(resume)
      ->excludes(moved)
      ->excludes(bay)
      ->excludes(recorded)
      ->excludes(planned);
  command.callback([arguments] {
    if (arguments->planned) return evaluate_planned(*arguments);
    if (!arguments->shake.empty()) return evaluate_shake(*arguments);
    if (!arguments->recorded.empty()) return evaluate_recorded(*arguments);
    arguments->moved ? evaluate_moved(*arguments) : evaluate(*arguments);
  });
}

}  // namespace rva::cli
