#include "detect/calibrated/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rva {
namespace {

struct Pixel {
  int u = 0;
  int v = 0;
};

bool is_highest_around(const PooledEvidence& evidence, Pixel peak, float sign) {
  const Image<float>& deviations = evidence.deviations;
  const float height = sign * deviations(peak.u, peak.v);
  const int left = std::max(peak.u - evidence.window_px, 0);
  const int right = std::min(peak.u + evidence.window_px, deviations.width() - 1);
  const int top = std::max(peak.v - evidence.window_px, 0);
  const int bottom = std::min(peak.v + evidence.window_px, deviations.height() - 1);
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      if (sign * deviations(u, v) > height) return false;
    }
  }
  return true;
}

// Returns the pixels of most positive and most negative evidence in a block.
std::array<Pixel, 2> extremes_of_block(const Image<float>& deviations, Pixel corner, int block_px) {
  std::array<Pixel, 2> extremes{corner, corner};
  float most = deviations(corner.u, corner.v);
  float least = most;
  for (int v = corner.v; v < std::min(corner.v + block_px, deviations.height()); ++v) {
    for (int u = corner.u; u < std::min(corner.u + block_px, deviations.width()); ++u) {
      const float height = deviations(u, v);
      if (height > most) {
        most = height;
        extremes[0] = {u, v};
      } else if (height < least) {
        least = height;
        extremes[1] = {u, v};
      }
    }
  }
  return extremes;
}

// Heights of the peaks of both signs. Only the extremes of each block as wide as a window are candidates,
// since a peak exceeds all pixels within that distance.
class Peaks {
 public:
  Peaks(const PooledEvidence& evidence, const Mask& unreliable)
      : evidence_(evidence), unreliable_(unreliable) {
    const int block_px = evidence.window_px;
    for (int v = 0; v < unreliable.height(); v += block_px) {
      for (int u = 0; u < unreliable.width(); u += block_px) {
        const auto [most, least] = extremes_of_block(evidence.deviations, {u, v}, block_px);
        add(most, 1.0F);
        add(least, -1.0F);
      }
    }
  }

  [[nodiscard]] const ByReliability<std::vector<float>>& heights() const { return heights_; }

 private:
  void add(Pixel peak, float sign) {
    const float height = sign * evidence_.deviations(peak.u, peak.v);
    if (height <= static_cast<float>(FalseAlarmTail::onset)) return;
    if (!is_highest_around(evidence_, peak, sign)) return;
    (unreliable_(peak.u, peak.v) != 0 ? heights_.unreliable : heights_.reliable).push_back(height);
  }

  const PooledEvidence& evidence_;
  const Mask& unreliable_;
  ByReliability<std::vector<float>> heights_;
};

}  // namespace

ByReliability<std::vector<float>> peaks_of(const PooledEvidence& evidence, const Mask& unreliable) {
  return Peaks(evidence, unreliable).heights();
}

Scale scale_of(PooledEvidence evidence, const Mask& unreliable, const ByReliability<PriorSlope>& prior_slopes,
               double false_findings) {
  const ByReliability<std::vector<float>> peaks = peaks_of(evidence, unreliable);
  const ByReliability<FalseAlarmTail> tails{fit_tail(peaks.reliable, prior_slopes.reliable),
                                            fit_tail(peaks.unreliable, prior_slopes.unreliable)};
  return {std::move(evidence),
          tails,
          {tails.reliable.height_of(false_findings), tails.unreliable.height_of(false_findings)}};
}

}  // namespace rva
