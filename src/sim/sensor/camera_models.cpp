#include "sim/sensor/camera_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "core/random.hpp"

namespace rva {
namespace {

StereoSensorOptions with_matcher(Matcher matcher, int window_px) {
  StereoSensorOptions sensor;
  sensor.matcher = matcher;
  sensor.window_px = window_px;
  return sensor;
}

std::string known_names() {
  std::string names;
  for (const CameraModel& model : camera_models()) names += fmt::format("{}, ", model.name);
  return names + "random:SEED or imperfect:SEED";
}

/// A parsed "random:7": the function that draws a camera, and its seed.
struct Drawn {
  StereoSensorOptions (*draw)(std::uint64_t) = nullptr;
  std::uint64_t seed = 0;
};

std::optional<Drawn> drawn_from_text(std::string_view text) {
  for (const auto& [prefix, draw] : {std::pair(std::string_view("random:"), &random_camera),
                                     std::pair(std::string_view("imperfect:"), &imperfect_camera)}) {
    if (!text.starts_with(prefix)) continue;
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [last, failure] = std::from_chars(text.data() + prefix.size(), end, seed);
    if (failure == std::errc() && last == end) return Drawn{draw, seed};
  }
  return std::nullopt;
}

}  // namespace

const std::vector<CameraModel>& camera_models() {
  static const std::vector<CameraModel> models{{"d435", {}},
                                               {"census-5", with_matcher(Matcher::census, 5)},
                                               {"census-13", with_matcher(Matcher::census, 13)},
                                               {"semi-global", with_matcher(Matcher::semi_global, 9)},
                                               {"correlation-5", with_matcher(Matcher::correlation, 5)},
                                               {"correlation-9", with_matcher(Matcher::correlation, 9)}};
  return models;
}

StereoSensorOptions random_camera(std::uint64_t seed) {
  constexpr std::array matchers{Matcher::census, Matcher::semi_global, Matcher::correlation};
  constexpr std::array windows_px{5, 7, 9, 11, 13};
  constexpr std::array units_mm{0.1, 1.0};
  Random random(mix(seed, 0xCA3E2A));
  const auto one_of = [&random](const auto& choices) {
    const auto at = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(choices.size())));
    return choices.at(std::min(at, choices.size() - 1));
  };
  StereoSensorOptions sensor;
  sensor.matcher = one_of(matchers);
  sensor.window_px = one_of(windows_px);
  sensor.focal_px = random.uniform(390.0, 460.0);
  sensor.baseline_mm = random.uniform(45.0, 60.0);
  sensor.lens_blur_px = random.uniform(0.4, 0.9);
  sensor.misalignment_px = random.uniform(0.0, 0.25);
  sensor.dots = static_cast<int>(random.uniform(3000.0, 9000.0));
  sensor.dot_share = random.uniform(0.6, 0.9);
  sensor.bounce = random.uniform(0.02, 0.1);
  sensor.full_well_e = random.uniform(1000.0, 6000.0);
  sensor.read_noise_e = random.uniform(3.0, 12.0);
  sensor.speckle = random.uniform(0.04, 0.18);
  sensor.wander = random.uniform(0.0, 0.08);
  sensor.levels = random.uniform(0.0, 0.06);
  sensor.flicker = random.uniform(0.0, 0.02);
  sensor.drift_px = random.uniform(0.02, 0.1);
  sensor.depth_unit_mm = one_of(units_mm);
  sensor.device = mix(seed, 0xDE71CE) % 1000000000U;
  return sensor;
}

StereoSensorOptions imperfect_camera(std::uint64_t seed) {
  StereoSensorOptions sensor = random_camera(seed);
  Random random(mix(seed, 0x14FEC7));
  sensor.rectification_px = random.uniform(0.03, 0.14);
  sensor.imager_difference = random.uniform(-0.2, 0.2);
  sensor.exposure_target = random.uniform(0.15, 0.8);
  sensor.speckle_turn_deg = random.uniform(0.02, 0.3);
  sensor.sway_mm = random.uniform(0.0, 0.1);
  return sensor;
}

StereoSensorOptions camera_model(const std::string& text, const std::string& option) {
  for (const CameraModel& model : camera_models()) {
    if (model.name == text) return model.sensor;
  }
  if (const std::optional<Drawn> drawn = drawn_from_text(text)) return drawn->draw(drawn->seed);
  throw OptionError(option, printable(text) + " is not a known camera model", "give one of " + known_names());
}

std::function<StereoSensorOptions(std::uint64_t)> camera_of_each(const std::string& text) {
  if (const std::optional<Drawn> drawn = drawn_from_text(text))
    return [drawn = *drawn](std::uint64_t seed) { return drawn.draw(mix(drawn.seed, seed)); };
  return [sensor = camera_model(text, "cameras")](std::uint64_t) { return sensor; };
}

std::string name_of_matcher(const StereoSensorOptions& sensor) {
  const std::string_view matcher = name_of(sensor.matcher);
  return sensor.matcher == Matcher::semi_global ? std::string(matcher)
                                                : fmt::format("{} {}", matcher, sensor.window_px);
}

}  // namespace rva
