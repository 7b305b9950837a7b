// The commands of `rva`. Each function adds a command to the program; the callback of the chosen command does
// the work.
#pragma once

#include <CLI/CLI.hpp>

namespace rva::cli {

/// The exit status of a command that did not fail, for main(): 0, or status_detected.
struct Outcome {
  int status = 0;  ///< exit status of the program
};

/// Exit statuses (docs/commands.md).
inline constexpr int status_failed = 1;

/// Exit status after wrong usage (UsageError).
inline constexpr int status_usage = 2;

/// Exit status of `rva detect` when it found a change.
inline constexpr int status_detected = 3;

void add_account_command(CLI::App& program);
void add_calibrate_command(CLI::App& program);
void add_cameras_command(CLI::App& program);
void add_detect_command(CLI::App& program, Outcome& outcome);
void add_evaluate_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_map_command(CLI::App& program);
void add_noise_command(CLI::App& program, Outcome& outcome);
void add_options_command(CLI::App& program);
void add_record_command(CLI::App& program);
void add_serve_command(CLI::App& program);
void add_simulate_command(CLI::App& program);

}  // namespace rva::cli
