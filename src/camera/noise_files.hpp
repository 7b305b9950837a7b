// The files of a measurement of noise (docs/noise.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "camera/noise.hpp"
#include "core/output_folder.hpp"

namespace rva {

/// The files of such a result, in the form that OutputFolder takes.
[[nodiscard]] std::vector<std::string> noise_files();

/// The content of `noise.json`.
[[nodiscard]] nlohmann::ordered_json json_of(const NoiseReport& report);

/// White where the first and the last frames differ (p < alpha), black where they do not, grey where there
/// was nothing to test.
[[nodiscard]] GrayImage drift_picture(const Noise& noise);

/// Writes `noise.json`, `std.png` (deviations in colour, with a scale) and `drift.png`.
/// @throws Error when a file cannot be written
void write_noise(const Noise& noise, const OutputFolder& out);

}  // namespace rva
