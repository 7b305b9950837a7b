// The option for a time stamp server, of commands that sign.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace rva::cli {

/// Adds `--timestamp-server`.
inline void add_timestamp_server(CLI::App& command, std::string& url) {
  command
      .add_option("--timestamp-server", url,
                  "time stamp server (RFC 3161) that states when a package was signed; without an answer, "
                  "the package states why it has no time stamp")
      ->type_name("URL");
}

}  // namespace rva::cli
