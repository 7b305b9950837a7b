#include "sim/sensor/trace_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/sensor/surface_light.hpp"

namespace rva {
namespace {

constexpr float dust_radius_m = 0.05F;
// Half lengths and half widths.
constexpr float smear_length_m = 0.05F;
constexpr float smear_width_m = 0.008F;
constexpr float finger_length_m = 0.008F;
constexpr float finger_width_m = 0.006F;
constexpr float reach_m = 0.06F;  // larger than the radius of any trace, for an early exit

// 1 inside, 0 from a relative distance of 1 on, with a linear transition of width `edge`.
float inside(float distance, float edge) { return std::clamp((1.0F - distance) / edge, 0.0F, 1.0F); }

float dust(const Eigen::Vector3f& from_middle, const Eigen::Vector3f& position) {
  constexpr float speck_m = 0.0015F;
  const float specks = std::clamp(0.5F + value_noise(position / speck_m), 0.0F, 1.0F);
  return inside(from_middle.norm() / dust_radius_m, 0.6F) * (0.5F + 0.5F * specks);
}

float smear(float along_m, float across_m) {
  constexpr float streak_m = 0.003F;
  const float streaks = 0.75F + 0.25F * std::sin(2.0F * std::numbers::pi_v<float> * across_m / streak_m);
  return inside(std::abs(along_m) / smear_length_m, 0.2F) * inside(std::abs(across_m) / smear_width_m, 0.4F) *
         streaks;
}

float fingerprint(float along_m, float across_m) {
  constexpr float ring_m = 0.0009F;
  const float distance = std::hypot(along_m / finger_length_m, across_m / finger_width_m);
  const float rings =
      0.5F + 0.5F * std::sin(2.0F * std::numbers::pi_v<float> * distance * finger_width_m / ring_m);
  return inside(distance, 0.2F) * (0.5F + 0.5F * rings);
}

// The share of the trace's contrast at a position, 0 to 1.
float share_at(const Trace& trace, const Eigen::Vector3f& position) {
  const Eigen::Vector3f from_middle = position - trace.at_m;
  if (from_middle.squaredNorm() > reach_m * reach_m) return 0.0F;
  const float along_m = from_middle.dot(trace.along);
  const float across_m = (from_middle - along_m * trace.along).norm();
  switch (trace.kind) {
    case TraceKind::dust:
      return dust(from_middle, position);
    case TraceKind::smear:
      return smear(along_m, across_m);
    case TraceKind::fingerprint:
      return fingerprint(along_m, across_m);
  }
  return 0.0F;
}

}  // namespace

float trace_light(std::span<const Trace> traces, const Eigen::Vector3f& position) {
  float light = 1.0F;
  for (const Trace& trace : traces)
    light *= std::max(1.0F + trace.contrast * share_at(trace, position), 0.0F);
  return light;
}

}  // namespace rva
