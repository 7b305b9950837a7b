#include "sim/sensor/rectification_error.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

}  // namespace

RectificationError::RectificationError(const StereoSensorOptions& options, const Intrinsics& imager,
                                       std::uint64_t seed)
    : amplitude_px_(options.rectification_px *
                    std::sqrt(2.0 / static_cast<double>(std::tuple_size_v<decltype(waves_)>))) {
  constexpr double fewest_periods = 0.4;
  constexpr double most_periods = 1.2;
  Random random(seed);
  for (Wave& wave : waves_) {
    const double direction = random.uniform(0.0, turn);
    const double periods = random.uniform(fewest_periods, most_periods);
    wave.turns_per_px = periods / imager.width * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    wave.phases = {random.uniform(0.0, turn), random.uniform(0.0, turn)};
  }
}

Eigen::Vector2d RectificationError::at(double u, double v) const {
  Eigen::Vector2d error = Eigen::Vector2d::Zero();
  if (is_none()) return error;
  for (const Wave& wave : waves_) {
    const double angle = turn * wave.turns_per_px.dot(Eigen::Vector2d(u, v));
    error +=
        amplitude_px_ * Eigen::Vector2d(std::cos(angle + wave.phases.x()), std::cos(angle + wave.phases.y()));
  }
  return error;
}

}  // namespace rva
