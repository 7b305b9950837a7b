#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "audit/site_keys.hpp"
#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/console_folder.hpp"
#include "cli/event_log.hpp"
#include "cli/live_rig.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/timestamp_server.hpp"
#include "core/error.hpp"
#include "core/folder_lock.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "inspect/inspector.hpp"
#include "inspect/recovery.hpp"
#include "server/signed_package.hpp"
#include "server/time_stamp_client.hpp"
#include "server/web_server.hpp"
#include "store/sqlite_records.hpp"

namespace rva::cli {
namespace {

// That of the account's password (hash_password()): a costlier key would protect nothing more.
constexpr PasswordCost key_cost{2, std::size_t{64} << 20U};

struct ServeArguments {
  std::string camera;
  std::string robot = "none";
  std::string data;
  std::string geometry;
  std::string config;
  std::string timestamp_server;
  std::uint64_t seed = 1;
  InspectorOptions inspector;
  DriveOptions drive;
  ServerOptions server;
  RealSenseOptions realsense;
  MeasureOptions measure;
};

// Refuses an option that is neither on the command line nor in the file.
void require(const std::string& value, const char* option, const std::string& what) {
  if (value.empty()) throw UsageError(option, "is missing", "give " + what);
}

std::unique_ptr<WebServer> open_server(const ServerOptions& options, const ServerParts& parts,
                                       const std::function<void(const Event&)>& log) {
  try {
    return std::make_unique<WebServer>(options, parts, log);
  } catch (const UnsafeAccessError& error) {
    throw OptionError(error.source(), error.problem(),
                      error.remedy() + " (--tls-certificate and --tls-key; rva account add)");
  }
}

void serve(ServeArguments arguments) {
  check_options(arguments.inspector);
  check_options(arguments.drive);
  check_options(arguments.measure);
  const PanTiltChain chain =
      arguments.geometry.empty() ? PanTiltChain{} : load_robot_geometry(arguments.geometry);
  if (arguments.server.console.empty()) arguments.server.console = console_folder();
  const TimeStamping stamping = time_stamping(arguments.timestamp_server, [](const Error& failure) {
    log_event({EventLevel::warning, "no-time-stamp", failure.what()});
  });
  LiveRig rig = open_live_rig(arguments.camera, arguments.robot, arguments.seed, arguments.realsense);
  std::error_code failure;
  std::filesystem::create_directories(arguments.data, failure);
  const FolderLock lock(arguments.data);
  SqliteRecords records(std::filesystem::path(arguments.data) / "rva.db");
  for (const std::string& line : recover_data(arguments.data, records))
    log_event({EventLevel::warning, "recovered", line});
  for (const std::string& line : remove_incomplete_packages(arguments.data))
    log_event({EventLevel::warning, "recovered", line});
  SiteKeys keys(std::filesystem::path(arguments.data) / site_keys_name, key_cost);
  for (const std::string& line : keys.repair()) log_event({EventLevel::warning, "recovered", line});
  LiveCamera camera(std::move(rig.camera));
  const std::unique_ptr<Drive> drive =
      rig.robot ? std::make_unique<Drive>(*rig.robot, arguments.drive) : nullptr;
  Inspector inspector({camera, drive.get(), chain}, records, arguments.data, arguments.inspector);
  Sessions sessions(records);
  Lease lease;
  const std::unique_ptr<WebServer> server =
      open_server(arguments.server,
                  {camera, drive.get(), inspector, sessions, lease, rig.simulated_work, arguments.measure,
                   &keys, stamping},
                  log_event);
  print("{}\n", server->address());
  static_cast<void>(std::fflush(stdout));
  log_event({EventLevel::notice,
             "started",
             "serves the console",
             {{"version", RVA_VERSION},
              {"address", server->address()},
              {"camera", arguments.camera},
              {"robot", arguments.robot},
              {"data", arguments.data}}});
  try {
    server->run();
  } catch (const Interrupted& interrupted) {
    log_event({EventLevel::notice, "stopped", "ends", {{"signal", std::to_string(interrupted.signal())}}});
    throw;
  }
}

}  // namespace

void add_serve_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("serve", "the operator console, in a browser");
  const auto arguments = std::make_shared<ServeArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE, replay:PATH or realsense[:SERIAL]")
      ->type_name("URI");
  command.add_option("--robot", arguments->robot, "sim, serial:DEVICE, or none")
      ->type_name("URI")
      ->capture_default_str();
  command.add_option("--data", arguments->data, "folder of inspections: records and captures")
      ->type_name("DIR");
  command.add_option("--geometry", arguments->geometry, "the robot's geometry, as rva calibrate writes it")
      ->type_name("FILE");
  command.add_option("--address", arguments->server.address, "address to listen on")->capture_default_str();
  add_flags(command, arguments->server);
  command
      .add_option("--tls-certificate", arguments->server.tls_certificate,
                  "PEM file, required for remote access")
      ->type_name("FILE");
  command.add_option("--tls-key", arguments->server.tls_key, "PEM file")->type_name("FILE");
  command.add_option("--console", arguments->server.console, "folder of the console's files")
      ->type_name("DIR");
  command.add_flag("--metrics", arguments->server.metrics,
                   "lets monitoring programs read /metrics (Prometheus), without signing in");
  add_timestamp_server(command, arguments->timestamp_server);
  command
      .add_option("--seed", arguments->seed,
                  "seed of a simulated camera's noise and a simulated robot's errors")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->inspector);
  add_flags(command, arguments->drive);
  add_flags(command, arguments->realsense);
  add_flags(command, arguments->measure);
  command.add_option("--config", arguments->config, "file with any of these options, as option = value")
      ->type_name("FILE");
  command.callback([arguments, &command] {
    if (!arguments->config.empty()) apply_config_file(command, arguments->config);
    require(arguments->camera, "--camera", "sim:SCENE, replay:PATH or realsense[:SERIAL]");
    require(arguments->data, "--data", "a folder");
    serve(*arguments);
  });
}

}  // namespace rva::cli
