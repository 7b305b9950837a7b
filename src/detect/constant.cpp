#include "detect/constant.hpp"

#include <cassert>

namespace rva {

Comparison compare_constant(const DepthImage& initial, const DepthImage& final, double unit_m,
                            const ConstantOptions& options, const Mask& left_out) {
  assert(initial.same_size(final));
  const double threshold = options.threshold_m / unit_m;
  const double clip = options.clip_m / unit_m;
  Comparison result(final.width(), final.height());
  std::size_t compared = 0;
  std::size_t unseen = 0;
  std::size_t beyond_clip = 0;
  std::size_t omitted = 0;
  for (std::size_t i = 0; i < final.size(); ++i) {
    const double before = initial[i];
    const double after = final[i];
    result.initial_m[i] = static_cast<float>(before * unit_m);
    result.final_m[i] = static_cast<float>(after * unit_m);
    if (is_left_out(left_out, i)) {
      ++omitted;
      continue;
    }
    if (final[i] == no_depth) continue;
    if (!(after < clip)) {
      ++beyond_clip;
    } else if (initial[i] == no_depth) {
      ++unseen;
    } else {
      ++compared;
      if (before - after > threshold) {
        result.changed[i] = mask_set;
        // A threshold of nothing has no multiples; then every unit of depth counts.
        result.evidence[i] = static_cast<float>((before - after) / (threshold > 0.0 ? threshold : 1.0));
      }
    }
  }
  const auto share = [&](std::size_t pixels) {
    return static_cast<double>(pixels) / static_cast<double>(final.size());
  };
  const std::size_t counted = compared + unseen + beyond_clip + omitted;
  result.coverage = {share(compared), share(unseen), share(final.size() - counted), share(beyond_clip),
                     left_out.empty() ? std::nullopt : std::optional(share(omitted))};
  return result;
}

}  // namespace rva
