// How the infrared imagers of a depth camera are exposed.
#pragma once

namespace rva {

/// The values that a setting of a camera accepts.
struct SettingRange {
  double least = 0.0;     ///< smallest value
  double greatest = 0.0;  ///< largest value
};

/// The exposure of the infrared imagers, from whose images depth is computed.
struct Exposure {
  bool automatic = false;  ///< whether the camera chooses both values
  double time_us = 0.0;    ///< exposure time, microseconds; meaningless if automatic
  double gain = 0.0;       ///< in the manufacturer's unit; meaningless if automatic

  bool operator==(const Exposure&) const = default;
};

/// The exposure that is set, and what can be set.
struct ExposureControl {
  Exposure set;          ///< as read back from the camera
  SettingRange time_us;  ///< of Exposure::time_us
  SettingRange gain;     ///< of Exposure::gain
};

/// @throws Error when a value of a fixed exposure is out of range or not a number
void check_exposure(const Exposure& exposure, const ExposureControl& control);

}  // namespace rva
