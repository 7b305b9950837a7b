#include "detect/thesis/constant.hpp"

#include <array>
#include <cassert>
#include <cstdint>

namespace rva {
namespace {

enum class Pixel : std::uint8_t { compared, unseen, not_measured, beyond_clip, left_out };
constexpr std::size_t kinds_of_pixels = 5;

Pixel kind_of(std::uint16_t before, std::uint16_t after, double clip, bool left_out) {
  if (left_out) return Pixel::left_out;
  if (after == no_depth) return Pixel::not_measured;
  if (!(after < clip)) return Pixel::beyond_clip;
  return before == no_depth ? Pixel::unseen : Pixel::compared;
}

}  // namespace

Comparison compare_constant(const DepthImage& initial, const DepthImage& final, double unit_m,
                            const ConstantOptions& options, const Mask& left_out) {
  assert(initial.same_size(final));
  const double threshold = options.threshold_m / unit_m;
  const double clip = options.clip_m / unit_m;
  Comparison result(final.width(), final.height());
  std::array<std::size_t, kinds_of_pixels> counts{};
  for (std::size_t i = 0; i < final.size(); ++i) {
    const double before = initial[i];
    const double after = final[i];
    result.initial_m[i] = static_cast<float>(before * unit_m);
    result.final_m[i] = static_cast<float>(after * unit_m);
    const Pixel kind = kind_of(initial[i], final[i], clip, is_left_out(left_out, i));
    ++counts.at(static_cast<std::size_t>(kind));
    if (kind != Pixel::compared || !(before - after > threshold)) continue;
    result.changed[i] = mask_set;
    // With a threshold of 0, evidence is in depth units instead of thresholds.
    result.evidence[i] = static_cast<float>((before - after) / (threshold > 0.0 ? threshold : 1.0));
  }
  const auto share = [&](Pixel kind) {
    return static_cast<double>(counts.at(static_cast<std::size_t>(kind))) / static_cast<double>(final.size());
  };
  result.coverage = {.compared = share(Pixel::compared),
                     .unseen = share(Pixel::unseen),
                     .invalid = share(Pixel::not_measured),
                     .beyond_clip = share(Pixel::beyond_clip),
                     .left_out = left_out.empty() ? std::nullopt : std::optional(share(Pixel::left_out))};
  return result;
}

}  // namespace rva
