#include "capture/no_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rva {
namespace {

constexpr std::uint16_t all_bits = 65535;
// Values that tools use for no measurement: the ends of the ranges of 10 to 16 bits, and round numbers,
// including negative ones that were read as unsigned.
constexpr std::array<std::uint16_t, 20> usual{1023,  2047,  4095,  8191,  9999,  10000, 16383,
                                              20000, 30000, 32767, 32768, 40000, 50000, 55537,
                                              60000, 65000, 65500, 65532, 65533, 65534};

using Histogram = std::vector<std::uint32_t>;

Histogram histogram_of(const DepthImage& frame) {
  Histogram histogram(all_bits + 1U, 0);
  for (const std::uint16_t depth : frame.pixels()) ++histogram[depth];
  return histogram;
}

std::uint16_t largest_below(const Histogram& histogram, std::uint16_t value) {
  std::uint16_t largest = value;
  while (largest > 0) {
    --largest;
    if (largest == 0 || histogram[largest] > 0) break;
  }
  return largest;
}

// The values of the first frame that mean no measurement, from the largest down.
std::vector<std::uint16_t> recognised(const Histogram& histogram, std::size_t pixels, double unit_m) {
  constexpr double far_m = 4.0;
  constexpr double far_beyond = 1.5;
  const std::size_t many = std::max<std::size_t>(16, pixels / 5000);
  std::vector<std::uint16_t> values;
  std::uint16_t value = histogram[all_bits] > 0 ? all_bits : largest_below(histogram, all_bits);
  while (value > 0) {
    const std::uint16_t below = largest_below(histogram, value);
    const bool is_usual = std::ranges::find(usual, value) != usual.end();
    const bool stands_apart = below > 0 && value > far_beyond * below;
    const bool means_nothing = value == all_bits || (is_usual && stands_apart && histogram[value] >= many &&
                                                     value * unit_m >= far_m);
    if (!means_nothing) break;
    values.push_back(value);
    value = below;
  }
  return values;
}

}  // namespace

NoDepthValues::NoDepthValues(std::vector<std::uint16_t> stated, double unit_m)
    : unit_m_(unit_m), values_(std::move(stated)) {
  values_.push_back(all_bits);
}

void NoDepthValues::learn(const std::function<DepthImage()>& first_frame) const {
  std::call_once(learnt_, [&] {
    const DepthImage frame = first_frame();
    const Histogram histogram = histogram_of(frame);
    for (const std::uint16_t value : recognised(histogram, frame.size(), unit_m_)) values_.push_back(value);
    std::ranges::sort(values_);
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    for (const std::uint16_t value : values_) {
      if (value == no_depth || histogram[value] == 0) continue;
      notes_.push_back(fmt::format("depth {} stands for no measurement ({:.1f} % of the first frame)", value,
                                   100.0 * histogram[value] / static_cast<double>(frame.size())));
    }
    are_zero_ = notes_.empty() || histogram[no_depth] > 0;
  });
}

void NoDepthValues::clear(DepthImage& frame, const std::function<DepthImage()>& first_frame) const {
  learn(first_frame);
  for (const std::uint16_t value : values_) std::ranges::replace(frame.pixels(), value, no_depth);
}

std::vector<std::string> NoDepthValues::notes(const std::function<DepthImage()>& first_frame) const {
  learn(first_frame);
  return notes_;
}

bool NoDepthValues::are_zero(const std::function<DepthImage()>& first_frame) const {
  learn(first_frame);
  return are_zero_;
}

DepthImage depth_from_metres(const Image<float>& depth_m, double unit_m) {
  DepthImage depth(depth_m.width(), depth_m.height());
  std::ranges::transform(depth_m.pixels(), depth.pixels().begin(), [&](float value_m) {
    const double units = std::round(static_cast<double>(value_m) / unit_m);
    return units >= 1.0 && units < all_bits ? static_cast<std::uint16_t>(units) : no_depth;
  });
  return depth;
}

}  // namespace rva
