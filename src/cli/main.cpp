#include <exception>
#include <new>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/event_log.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/options.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"

namespace {

using rva::cli::Outcome;

// CLI11 would only report that some command is required.
void require_known_command(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
  }
  throw rva::UsageError(rva::printable(argv[1]), "no such command", "see rva --help");
}

int run(int argc, char** argv) {
  CLI::App program("Finds what was left behind: compares depth before and after the work.", "rva");
  program.set_version_flag("--version", RVA_VERSION);
  program.require_subcommand(1);
  program.fallthrough(false);
  Outcome outcome;
  rva::cli::add_detect_command(program, outcome);
  rva::cli::add_evaluate_command(program);
  rva::cli::add_noise_command(program, outcome);
  rva::cli::add_info_command(program);
  rva::cli::add_export_command(program);
  rva::cli::add_export_crops_command(program);
  rva::cli::add_record_command(program);
  rva::cli::add_cameras_command(program);
  rva::cli::add_simulate_command(program);
  rva::cli::add_map_command(program);
  rva::cli::add_calibrate_command(program);
  rva::cli::add_doctor_command(program, outcome);
  rva::cli::add_robot_command(program, outcome);
  rva::cli::add_serve_command(program);
  rva::cli::add_account_command(program);
  rva::cli::add_inspection_command(program);
  rva::cli::add_key_command(program);
  rva::cli::add_options_command(program);
  require_known_command(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0)
      throw rva::UsageError("usage", rva::printable(error.what()), "see --help");
    program.exit(error);  // prints what --help or --version asked for
    rva::cli::require_printed();
    return 0;
  }
  rva::cli::require_printed();
  return outcome.status;
}

}  // namespace

int main(int argc, char** argv) {
  rva::note_interrupts();
  try {
    return run(argc, argv);
  } catch (const rva::Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const rva::OptionError& error) {
    rva::cli::complain("--" + rva::printable(error.what()));
    return rva::cli::status_usage;
  } catch (const rva::UsageError& error) {
    rva::cli::complain(rva::printable(error.what()));
    return rva::cli::status_usage;
  } catch (const rva::ExistsError& error) {
    rva::cli::complain(rva::printable(error.what()) + " with --overwrite");
    return rva::cli::status_failed;
  } catch (const rva::Error& error) {
    rva::cli::complain(rva::printable(error.what()));
    return rva::cli::status_failed;
  } catch (const std::bad_alloc&) {
    rva::cli::complain("memory: there is not enough; close other programs or use fewer frames");
    return rva::cli::status_failed;
  } catch (const std::system_error& error) {
    rva::cli::complain("system: " + error.code().message() + "; close other programs and try again");
    return rva::cli::status_failed;
  } catch (const std::exception& error) {
    rva::cli::complain("internal error (" + rva::printable(error.what()) +
                       "); please report it with the command that led to it");
    return rva::cli::status_failed;
  }
}
