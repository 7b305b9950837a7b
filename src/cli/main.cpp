#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/commands.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace {

using rva::cli::Outcome;

// A result that could not be printed was not delivered: the disk behind a redirection may be full.
void require_printed() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw rva::Error("stdout", "the result cannot be written", "free some space or choose another place");
  }
}

int run(int argc, char** argv) {
  CLI::App program("Finds what was left behind: compares depth before and after the work.", "rva");
  program.set_version_flag("--version", RVA_VERSION);
  program.require_subcommand(1);
  program.fallthrough(false);
  Outcome outcome;
  rva::cli::add_detect_command(program, outcome);
  rva::cli::add_noise_command(program, outcome);
  rva::cli::add_info_command(program, outcome);
  rva::cli::add_options_command(program, outcome);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked = error.get_exit_code() == 0;  // --help, --version
    program.exit(error);
    return asked ? 0 : rva::cli::status_usage;
  }
  require_printed();
  return outcome.status;
}

}  // namespace

int main(int argc, char** argv) {
  rva::note_interrupts();
  try {
    return run(argc, argv);
  } catch (const rva::Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const rva::UsageError& error) {
    fmt::print(stderr, "rva: {}\n", error.what());
    return rva::cli::status_usage;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "rva: {}\n", error.what());
    return rva::cli::status_failed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva: internal error ({}); please report it with the command that led to it\n",
               error.what());
    return rva::cli::status_failed;
  }
}
