// Options structs as command line flags.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/options.hpp"
#include "depth/capture.hpp"

namespace rva::cli {

/// A flag for each field of the struct, with its default, unit and sentence from the struct's description.
template <typename Options>
void add_flags(CLI::App& command, Options& options) {
  Options::describe(options, [&](auto& value, const OptionField& field) {
    command.add_option(fmt::format("--{}", field.name), value, std::string(field.help))
        ->type_name(field.unit.empty() ? "NUMBER" : std::string(field.unit))
        ->capture_default_str();
  });
}

/// What every command that opens captures takes.
struct CaptureFlags {
  std::vector<double> intrinsics;

  void add_to(CLI::App& command) {
    command.add_option("--intrinsics", intrinsics, "the depth camera of a capture that carries none (TUM)")
        ->type_name("FX,FY,CX,CY")
        ->delimiter(',')
        ->expected(4);
  }

  [[nodiscard]] CaptureOptions options() const {
    CaptureOptions options;
    if (intrinsics.empty()) return options;
    Intrinsics camera;
    camera.width = camera.height = 1;  // replaced by the size of the first image
    camera.fx = intrinsics[0];
    camera.fy = intrinsics[1];
    camera.cx = intrinsics[2];
    camera.cy = intrinsics[3];
    try {
      camera.check();
    } catch (const Error& error) {
      throw UsageError("--intrinsics", error.problem(), error.remedy());
    }
    options.intrinsics = camera;
    return options;
  }
};

}  // namespace rva::cli
