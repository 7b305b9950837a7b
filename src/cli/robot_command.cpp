#include "cli/commands.hpp"

namespace rva::cli {

void add_robot_command(CLI::App& program, Outcome& outcome) {
  CLI::App& command =
      *program.add_subcommand("robot", "sets a robot up, and measures whether it is fit for inspections");
  command.require_subcommand(1);
  add_robot_setup_command(command, outcome);
  add_repeatability_command(command, outcome);
}

}  // namespace rva::cli
