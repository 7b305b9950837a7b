#include "camera/realsense/realsense_settings.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

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
