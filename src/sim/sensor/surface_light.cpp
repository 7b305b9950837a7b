#include "sim/sensor/surface_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/vector_clones.hpp"

namespace rva {

namespace {

// Replaces std::floor, which compiles to a function call unless the target is known to have an instruction
// for it.
int floor_of(float number) {
  const int whole = static_cast<int>(number);
  return static_cast<float>(whole) > number ? whole - 1 : whole;
}

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }
float mix_of(float a, float b, float t) { return a + t * (b - a); }

// Exponentiation by squaring: a highlight costs only a few multiplications.
float power(float base, int exponent) {
  float result = 1.0F;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) result *= base;
  }
  return result;
}

// Corners of a lattice cell: bit 0 of the index selects the side along x, bit 1 along y, bit 2 along z.
constexpr std::size_t corners = 8;

/// A number in [-1, 1) for each corner of a cell of the lattice.
RVA_VECTOR_CLONES
void lattice(const Eigen::Vector3i& cell, std::array<float, corners>& values) {
  constexpr std::uint32_t of_x = 0x8DA6B343U;
  constexpr std::uint32_t of_y = 0xD8163841U;
  constexpr std::uint32_t of_z = 0xCB1AB31FU;
  static constexpr std::array<std::uint32_t, corners> steps{
      0, of_x, of_y, of_x + of_y, of_z, of_x + of_z, of_y + of_z, of_x + of_y + of_z};
  const std::uint32_t first = static_cast<std::uint32_t>(cell.x()) * of_x +
                              static_cast<std::uint32_t>(cell.y()) * of_y +
                              static_cast<std::uint32_t>(cell.z()) * of_z;
  for (std::size_t i = 0; i < corners; ++i) {
    std::uint32_t h = first + steps[i];
    h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12U)) * 0x297A2D39U;
    h ^= h >> 15U;
    // Halved, since vector instructions convert signed integers only.
    values[i] = static_cast<float>(static_cast<std::int32_t>(h >> 1U)) * 0x1.0p-30F - 1.0F;
  }
}

// Value noise: smooth interpolation between lattice values.
float noise(const Eigen::Vector3f& p) {
  const Eigen::Vector3i cell(floor_of(p.x()), floor_of(p.y()), floor_of(p.z()));
  const Eigen::Vector3f within = p - cell.cast<float>();
  const float tx = smooth(within.x());
  const float ty = smooth(within.y());
  const float tz = smooth(within.z());
  std::array<float, corners> at{};
  lattice(cell, at);
  const auto edge = [&](std::size_t corner) { return mix_of(at[corner], at[corner + 1], tx); };
  return mix_of(mix_of(edge(0), edge(2), ty), mix_of(edge(4), edge(6), ty), tz);
}

// The factor of light that dirt leaves: patches of the size of a hand, with specks of a few millimetres.
float under_dirt(float dirt, const Eigen::Vector3f& position) {
  constexpr float patch_m = 0.06F;
  constexpr float speck_m = 0.004F;
  const float patch = std::clamp(0.5F + noise(position / patch_m), 0.0F, 1.0F);
  const float speck = std::clamp(0.5F + noise(position / speck_m), 0.0F, 1.0F);
  return 1.0F - dirt * patch * (0.5F + 0.5F * speck);
}

float grain_of_coat(const Material& material, const Eigen::Vector3f& position) {
  if (material.grain <= 0.0) return 1.0F;
  // The standard deviation of the field is about a third, so 3 scales it to the material's contrast.
  const float contrast = 3.0F * static_cast<float>(material.grain);
  return std::max(0.0F, 1.0F + contrast * noise(position * static_cast<float>(1.0 / material.grain_m)));
}

}  // namespace

float value_noise(const Eigen::Vector3f& position) { return noise(position); }

float grain_at(const Material& material, const Eigen::Vector3f& position) {
  const float grain = grain_of_coat(material, position);
  return material.dirt > 0.0 ? grain * under_dirt(static_cast<float>(material.dirt), position) : grain;
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
  // Soft bright patches stand in for the unknown surroundings.
  const float patches = 0.5F + mirrored.x() * mirrored.y();
  const float above = 0.5F + 0.5F * mirrored.z();
  return diffuse + static_cast<float>(material.specular) * above * (0.5F + patches);
}

}  // namespace rva
