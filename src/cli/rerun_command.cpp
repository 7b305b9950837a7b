#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "inspect/rerun.hpp"

namespace rva::cli {
namespace {

struct RerunArguments {
  std::string data;
  std::int64_t inspection = 0;
  std::optional<int> comparison;
  std::optional<std::string> geometry;
  std::string out;
};

void rerun(const RerunArguments& arguments) {
  const PanTiltChain chain = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  const int number = arguments.comparison.value_or(latest_comparison(history));
  const Rerun done = rerun_comparison(history, InspectionFolder(arguments.data, arguments.inspection), number,
                                      chain, arguments.out, terminal_progress());
  if (done.differences.empty()) {
    print("comparison {} gives the recorded results again: {} findings, {} files\n", number, done.findings,
          done.files);
    return;
  }
  for (const std::string& line : done.differences) print("{}\n", printable(line));
  throw Error(
      fmt::format("comparison {} of inspection {}", number, arguments.inspection),
      "gives other results than those that are recorded",
      "see " + printable(arguments.out) +
          "; causes are another version of the program, another robot geometry, and changed captures");
}

}  // namespace

void add_rerun_command(CLI::App& inspection) {
  CLI::App& command = *inspection.add_subcommand(
      "rerun", "compares the captures again, and states whether the results are as they were recorded");
  const auto arguments = std::make_shared<RerunArguments>();
  add_recorded_inspection(command, arguments->data, arguments->inspection);
  command.add_option("--comparison", arguments->comparison, "its number; by default the latest")
      ->check(CLI::PositiveNumber)
      ->type_name("K");
  command
      .add_option("--geometry", arguments->geometry,
                  "the robot's geometry, as the server was given it that compared them")
      ->type_name("FILE");
  command.add_option("--out", arguments->out, "folder for the results")->required()->type_name("DIR");
  command.callback([arguments] { rerun(*arguments); });
}

}  // namespace rva::cli
