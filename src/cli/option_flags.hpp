// Command line flags for the structs of options.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include "capture/capture.hpp"
#include "capture/stated_camera.hpp"
#include "core/enum_names.hpp"
#include "core/error.hpp"
#include "core/options.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"

namespace rva::cli {

/// Refuses what is not a number of this type from `low` to `high`. CLI11 alone accepts -1 as a very large
/// count, 1e20 as the largest, and NaN as any number.
template <typename Number>
CLI::Validator number_within(Number low, Number high) {
  const auto problem = [low, high](const std::string& text) {
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    Number value{};
    const auto [rest, failure] = std::from_chars(begin, end, value);
    if (failure == std::errc{} && rest == end && value >= low && value <= high) return std::string();
    return fmt::format("{} is not a {}number from {} to {}", printable(text),
                       std::is_integral_v<Number> ? "whole " : "", low, high);
  };
  return {problem, ""};
}

/// The number of frames that a written capture may have: their file names have six digits.
inline CLI::Validator frame_count() { return number_within<std::size_t>(1, 1'000'000); }

/// Refuses what is not the name of a value of this enumeration.
template <typename Value>
CLI::Validator name_among() {
  const auto names = names_of<Value>();
  return CLI::IsMember(std::vector<std::string>(names.begin(), names.end()));
}

/// The start of a sequence of random numbers: any whole number of 64 bits, without a sign.
inline CLI::Validator any_seed() {
  return number_within<std::uint64_t>(0, std::numeric_limits<std::uint64_t>::max());
}

/// A flag for each field of the struct, with its default, unit and sentence from the struct's description.
/// A bool may be given without a value, which turns it on.
template <typename Options>
void add_flags(CLI::App& command, Options& options) {
  Options::describe(options, [&](auto& value, const OptionField& field) {
    CLI::Option& flag = *command.add_option(fmt::format("--{}", field.name), value, std::string(field.help));
    flag.type_name(field.unit.empty() ? "NUMBER" : std::string(field.unit))->capture_default_str();
    // CLI11 takes a missing value for the default, unless the option was one without values before.
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>) flag.expected(0)->expected(0, 1);
  });
}

/// The options of every command that opens captures.
struct CaptureFlags {
  std::vector<double> intrinsics;       ///< `--intrinsics`: fx, fy, cx, cy, px; empty if not given
  std::vector<std::uint16_t> no_depth;  ///< `--no-depth`
  std::optional<double> depth_unit_mm;  ///< `--depth-unit`; empty if not given
  std::string topic;                    ///< `--topic`; empty if not given

  /// Adds all of these options to a command.
  void add_to(CLI::App& command) {
    add_without_unit_to(command);
    command
        .add_option("--depth-unit", depth_unit_mm,
                    "one step of the depth images, whatever the capture states")
        ->type_name("mm")
        ->check(number_within(least_depth_unit_mm, most_depth_unit_mm));
  }

  /// For commands whose camera has an option --depth-unit of its own.
  void add_without_unit_to(CLI::App& command) {
    command
        .add_option("--no-depth", no_depth,
                    "a value of depth that means no measurement, besides 0 and 65535; may be repeated")
        ->type_name("VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(number_within<int>(0, 65535));
    command
        .add_option("--topic", topic,
                    "the topic of the depth images in a recording of ROS, where there are several")
        ->type_name("NAME");
    command
        .add_option(
            "--intrinsics", intrinsics,
            "the depth camera of a capture that carries none (TUM, images alone, ROS without camera_info)")
        ->type_name("FX,FY,CX,CY")
        ->delimiter(',')
        ->expected(4);
  }

  /// The options for open_capture(). @throws OptionError for intrinsics that no camera can have
  [[nodiscard]] CaptureOptions options() const {
    CaptureOptions options;
    options.no_depth = no_depth;
    if (!topic.empty()) options.topic = topic;
    if (depth_unit_mm) options.depth_unit_m = m_per_mm * *depth_unit_mm;
    if (!intrinsics.empty())
      options.intrinsics = stated_intrinsics({intrinsics[0], intrinsics[1], intrinsics[2], intrinsics[3]});
    return options;
  }
};

}  // namespace rva::cli
