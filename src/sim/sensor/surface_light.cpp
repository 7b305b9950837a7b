#include "sim/sensor/surface_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rva {

namespace {

// A number in [-1, 1) for each corner of a lattice.
float lattice(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343U +
                    static_cast<std::uint32_t>(y) * 0xD8163841U + static_cast<std::uint32_t>(z) * 0xCB1AB31FU;
  h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12U)) * 0x297A2D39U;
  h ^= h >> 15U;
  return static_cast<float>(h) * 0x1.0p-31F - 1.0F;
}

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }
float mix_of(float a, float b, float t) { return a + t * (b - a); }

// By squaring: a highlight costs a few multiplications, and the same everywhere.
float power(float base, int exponent) {
  float result = 1.0F;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) result *= base;
  }
  return result;
}

// Value noise: lattice values, joined smoothly.
float noise(const Eigen::Vector3f& p) {
  const Eigen::Vector3f floor(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  const auto x = static_cast<std::int32_t>(floor.x());
  const auto y = static_cast<std::int32_t>(floor.y());
  const auto z = static_cast<std::int32_t>(floor.z());
  const float tx = smooth(p.x() - floor.x());
  const float ty = smooth(p.y() - floor.y());
  const float tz = smooth(p.z() - floor.z());
  const auto edge = [&](std::int32_t dy, std::int32_t dz) {
    return mix_of(lattice(x, y + dy, z + dz), lattice(x + 1, y + dy, z + dz), tx);
  };
  return mix_of(mix_of(edge(0, 0), edge(1, 0), ty), mix_of(edge(0, 1), edge(1, 1), ty), tz);
}

}  // namespace

float grain_at(const Material& material, const Eigen::Vector3f& position) {
  if (material.grain <= 0.0) return 1.0F;
  // Values of the field have a standard deviation of about a third.
  const float contrast = 3.0F * static_cast<float>(material.grain);
  return std::max(0.0F, 1.0F + contrast * noise(position / static_cast<float>(material.grain_m)));
}

float reflected(const Material& material, float albedo, const SurfacePoint& point,
                const Eigen::Vector3f& to_light) {
  const float cosine = point.normal.dot(to_light);
  if (cosine <= 0.0F) return 0.0F;
  float share = albedo;
  if (material.specular > 0.0) {
    const Eigen::Vector3f half = (to_light + point.to_eye).normalized();
    const float peak = static_cast<float>(material.specular * (material.gloss + 8) / 8.0);
    share += peak * power(std::max(0.0F, point.normal.dot(half)), material.gloss);
  }
  return share * cosine;
}

float reflected_surroundings(const Material& material, float albedo, const SurfacePoint& point) {
  const float diffuse = albedo * (0.6F + 0.4F * point.normal.z());
  if (material.specular <= 0.0) return diffuse;
  const Eigen::Vector3f mirrored = 2.0F * point.normal.dot(point.to_eye) * point.normal - point.to_eye;
  // Soft bright patches stand for whatever is around.
  const float patches = 0.5F + mirrored.x() * mirrored.y();
  const float above = 0.5F + 0.5F * mirrored.z();
  return diffuse + static_cast<float>(material.specular) * above * (0.5F + patches);
}

}  // namespace rva
