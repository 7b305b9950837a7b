#include "camera/exposure.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace rva {
namespace {

void check_value(const char* name, double value, const SettingRange& range, const char* unit) {
  if (value >= range.least && value <= range.greatest) return;  // false for what is not a number
  throw Error(name, fmt::format("{:g}{} is outside the camera's range", value, unit),
              fmt::format("choose {:g} to {:g}{}", range.least, range.greatest, unit));
}

}  // namespace

void check_exposure(const Exposure& exposure, const ExposureControl& control) {
  if (exposure.automatic) return;
  check_value("exposure time", exposure.time_us, control.time_us, " us");
  check_value("gain", exposure.gain, control.gain, "");
}

}  // namespace rva
