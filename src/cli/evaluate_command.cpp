#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "evaluate/report.hpp"
#include "sim/scene/scene_file.hpp"

namespace rva::cli {
namespace {

struct EvaluateArguments {
  std::string out;
  std::string scene;
  StudyOptions study;
  bool overwrite = false;
};

void evaluate(const EvaluateArguments& arguments) {
  OutputFolder out(arguments.out, {"evaluation.json"},
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  std::optional<Scene> scene;
  if (!arguments.scene.empty()) scene = load_scene(arguments.scene);
  const std::vector<Inspection> inspections = run_study(arguments.study, scene, terminal_progress());
  const std::vector<Tally> tallies = tally(inspections);
  write_file(out.path("evaluation.json"), to_json(inspections, tallies));
  out.commit();
  print("{}{}\n", to_table(tallies), arguments.out);
}

}  // namespace

void add_evaluate_command(CLI::App& program, Outcome& /*outcome*/) {
  CLI::App& command = *program.add_subcommand(
      "evaluate", "measures on simulated inspections how reliably the static methods detect");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command.add_option("--out", arguments->out, "folder for evaluation.json")->required()->type_name("DIR");
  command.add_option("--scene", arguments->scene,
                     "inspect this scene again and again; without it, wings and debris drawn by chance");
  command.add_option("--frames", arguments->study.frames, "depth frames of either capture, ascending")
      ->delimiter(',')
      ->type_name("N,N...")
      ->capture_default_str();
  add_flags(command, arguments->study);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier evaluation in DIR");
  command.callback([arguments] { evaluate(*arguments); });
}

}  // namespace rva::cli
