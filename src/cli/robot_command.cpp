#include "cli/commands.hpp"

namespace rva::cli {

void add_robot_command(CLI::App& program, Outcome& outcome) {
  CLI::App& command = *program.add_subcommand("robot", "measures whether a robot is fit for inspections");
  command.require_subcommand(1);
  add_repeatability_command(command, outcome);
}

}  // namespace rva::cli
