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

/// Exit status of `rva detect` when it found a change, and of checks of a device that is not fit.
inline constexpr int status_detected = 3;

/// `rva account`: adds, removes and lists the accounts of the console.
void add_account_command(CLI::App& program);
/// `rva calibrate`: estimates the geometry of the robot from its captures.
void add_calibrate_command(CLI::App& program);
/// `rva cameras`: lists the cameras that are plugged in.
void add_cameras_command(CLI::App& program);
/// `rva detect`: what changed between two sides.
/// @param outcome its status becomes status_detected if a change was found; must outlive `program`
void add_detect_command(CLI::App& program, Outcome& outcome);
/// `rva doctor`: checks computer, camera and robot, and states what to do.
/// @param outcome its status becomes status_detected if a check failed; must outlive `program`
void add_doctor_command(CLI::App& program, Outcome& outcome);
/// `rva evaluate`: how much debris is found, and how many false findings there are, in many inspections.
void add_evaluate_command(CLI::App& program);
/// `rva export`: an inspection of the console as a folder.
void add_export_command(CLI::App& program);
/// `rva export-crops`: findings that were decided on, as labelled pictures.
void add_export_crops_command(CLI::App& program);
/// `rva info`: what a capture contains.
void add_info_command(CLI::App& program);
/// `rva inspection`: packages of inspections that stand on their own.
void add_inspection_command(CLI::App& program);
/// `rva key`: keys that sign packages.
void add_key_command(CLI::App& program);
/// `rva map`: drives the waypoints and builds one point cloud of the bay.
void add_map_command(CLI::App& program);
/// `rva noise`: how much the depth of a still scene varies.
/// @param outcome its status becomes status_detected if the camera differs from its history; must outlive
/// `program`
void add_noise_command(CLI::App& program, Outcome& outcome);
/// `rva options`: the numeric options of all commands, as docs/options.md.
void add_options_command(CLI::App& program);
/// `rva record`: records a capture, or dithered captures, from a camera.
void add_record_command(CLI::App& program);
/// `rva robot`: what a robot is checked with before it is used.
/// @param outcome its status becomes status_detected if the robot is not fit; must outlive `program`
void add_robot_command(CLI::App& program, Outcome& outcome);
/// `rva serve`: the console, in a browser.
void add_serve_command(CLI::App& program);
/// `rva simulate`: a capture of a scene, with its truth.
void add_simulate_command(CLI::App& program);

/// Adds `verify` to the command `inspection`.
void add_verify_command(CLI::App& inspection);
/// Adds `report` to the command `inspection`.
void add_report_command(CLI::App& inspection);
/// Adds `rerun` to the command `inspection`.
void add_rerun_command(CLI::App& inspection);
/// Adds `actions` to the command `inspection`.
void add_actions_command(CLI::App& inspection);
/// Adds `trends` to the command `inspection`.
void add_trends_command(CLI::App& inspection);
/// Adds `list` to the command `inspection`.
void add_inspection_list_command(CLI::App& inspection);
/// Adds `repeatability` to the command `robot`.
/// @param outcome its status becomes status_detected if the robot is not fit; must outlive `robot`
void add_repeatability_command(CLI::App& robot, Outcome& outcome);
/// Adds `setup` to the command `robot`.
/// @param outcome its status becomes status_detected if a servo is missing; must outlive `robot`
void add_robot_setup_command(CLI::App& robot, Outcome& outcome);

}  // namespace rva::cli
