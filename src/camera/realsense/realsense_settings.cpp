#include "camera/realsense/realsense_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.hpp"

namespace rva {
namespace {

struct Setting {
  rs2_option option;
  double value;
};

// The order matters: exposure and gain are refused while exposure is automatic.
std::array<Setting, 6> settings_of(const RealSenseOptions& options) {
  const bool lit = options.laser_power_mw > 0.0;
  return {{{RS2_OPTION_ENABLE_AUTO_EXPOSURE, 0.0},
           {RS2_OPTION_EXPOSURE, options.exposure_us},
           {RS2_OPTION_GAIN, options.gain},
           {RS2_OPTION_EMITTER_ENABLED, lit ? 1.0 : 0.0},
           {RS2_OPTION_LASER_POWER, options.laser_power_mw},
           {RS2_OPTION_DEPTH_UNITS, 0.001 * options.depth_unit_mm}}};
}

}  // namespace

std::vector<std::string> apply_settings(const rs2::sensor& depth_sensor, const RealSenseOptions& options) {
  std::vector<std::string> notes;
  for (const Setting& setting : settings_of(options)) {
    const char* const name = rs2_option_to_string(setting.option);
    if (!depth_sensor.supports(setting.option)) {
      notes.push_back(fmt::format("the camera has no setting '{}'", name));
      continue;
    }
    if (depth_sensor.is_option_read_only(setting.option)) continue;
    try {
      depth_sensor.set_option(setting.option, static_cast<float>(setting.value));
    } catch (const rs2::error&) {
      // The actual value is read below, and a difference is reported.
    }
    const double now = static_cast<double>(depth_sensor.get_option(setting.option));
    const double step = static_cast<double>(depth_sensor.get_option_range(setting.option).step);
    if (std::abs(now - setting.value) > 0.51 * step + 1e-6 * std::abs(setting.value))
      notes.push_back(fmt::format("'{}' is {:.6g}, not {:.6g} as requested", name, now, setting.value));
  }
  return notes;
}

std::optional<ExposureControl> read_exposure(const rs2::sensor& depth_sensor, double rate_hz) {
  if (!depth_sensor.supports(RS2_OPTION_EXPOSURE) || !depth_sensor.supports(RS2_OPTION_GAIN))
    return std::nullopt;
  const auto value = [&](rs2_option option) { return static_cast<double>(depth_sensor.get_option(option)); };
  const auto range = [&](rs2_option option) {
    const rs2::option_range accepted = depth_sensor.get_option_range(option);
    return SettingRange{static_cast<double>(accepted.min), static_cast<double>(accepted.max)};
  };
  ExposureControl control;
  control.set = {.automatic = depth_sensor.supports(RS2_OPTION_ENABLE_AUTO_EXPOSURE) &&
                              value(RS2_OPTION_ENABLE_AUTO_EXPOSURE) != 0.0,
                 .time_us = value(RS2_OPTION_EXPOSURE),
                 .gain = value(RS2_OPTION_GAIN)};
  control.time_us = range(RS2_OPTION_EXPOSURE);
  control.time_us.greatest = std::min(control.time_us.greatest, us_per_s / rate_hz);
  control.gain = range(RS2_OPTION_GAIN);
  return control;
}

void apply_exposure(const rs2::sensor& depth_sensor, const Exposure& exposure) {
  if (depth_sensor.supports(RS2_OPTION_ENABLE_AUTO_EXPOSURE))
    depth_sensor.set_option(RS2_OPTION_ENABLE_AUTO_EXPOSURE, exposure.automatic ? 1.0F : 0.0F);
  if (exposure.automatic) return;
  depth_sensor.set_option(RS2_OPTION_EXPOSURE, static_cast<float>(exposure.time_us));
  depth_sensor.set_option(RS2_OPTION_GAIN, static_cast<float>(exposure.gain));
}

std::map<std::string, double> read_settings(rs2::sensor sensor) {
  std::map<std::string, double> settings;
  for (const rs2_option option : sensor.get_supported_options()) {
    try {
      settings[rs2_option_to_string(option)] = static_cast<double>(sensor.get_option(option));
    } catch (const rs2::error&) {
      // Some options can only be set, others can be read only while the camera is streaming.
    }
  }
  return settings;
}

}  // namespace rva
