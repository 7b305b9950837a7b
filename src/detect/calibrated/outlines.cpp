#include "detect/calibrated/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "depth/blobs.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr float common = -1000.0F;  // below any rarity

/// Significant evidence of one sign at one scale, cropped to the part of the image that contains all of it;
/// empty if there is none.
struct Sighting {
  cv::Rect where;
  Mask around;          ///< within half a window of where the threshold is exceeded
  Image<float> rarity;  ///< -log10 of the expected number of false findings as strong
};

bool exceeds_anywhere(const Scale& scale, float sign) {
  double least = 0.0;
  double most = 0.0;
  cv::minMaxLoc(as_mat(scale.evidence.deviations), &least, &most);
  return (sign > 0.0F ? most : -least) > std::min(scale.thresholds.reliable, scale.thresholds.unreliable);
}

// Evidence of a pixel if it exceeds the threshold, else 0.
float excess(const Scale& scale, const Mask& unreliable, float sign, int u, int v) {
  const float deviations = sign * scale.evidence.deviations(u, v);
  return static_cast<double>(deviations) > scale.thresholds.at(unreliable(u, v)) ? deviations : 0.0F;
}

cv::Rect where_it_exceeds(const Scale& scale, const Mask& unreliable, float sign) {
  cv::Rect where;
  for (int v = 0; v < unreliable.height(); ++v) {
    for (int u = 0; u < unreliable.width(); ++u) {
      if (excess(scale, unreliable, sign, u, v) > 0.0F) where |= cv::Rect(u, v, 1, 1);
    }
  }
  return where;
}

// Equation 27 of docs/math.md.
Sighting sighting(const Scale& scale, const Mask& unreliable, double log10_looks, float sign) {
  if (!exceeds_anywhere(scale, sign)) return {};
  const cv::Rect exceeding = where_it_exceeds(scale, unreliable, sign);
  if (exceeding.empty()) return {};
  const int half = scale.evidence.window_px / 2;
  const cv::Rect where = cv::Rect(exceeding.x - half, exceeding.y - half, exceeding.width + 2 * half,
                                  exceeding.height + 2 * half) &
                         cv::Rect(0, 0, unreliable.width(), unreliable.height());
  Sighting seen{where, Mask(where.width, where.height), Image<float>(where.width, where.height, common)};
  for (int v = 0; v < where.height; ++v) {
    for (int u = 0; u < where.width; ++u) {
      const float deviations = excess(scale, unreliable, sign, where.x + u, where.y + v);
      if (deviations <= 0.0F) continue;
      const FalseAlarmTail& tail = scale.tails.at(unreliable(where.x + u, where.y + v));
      seen.around(u, v) = mask_set;
      seen.rarity(u, v) =
          static_cast<float>(-log10_looks - tail.log10_expected_above(static_cast<double>(deviations)));
    }
  }
  const cv::Mat window = cv::Mat::ones(scale.evidence.window_px, scale.evidence.window_px, CV_8U);
  cv::Mat around = as_mat(seen.around);
  cv::Mat rarity = as_mat(seen.rarity);
  cv::dilate(around, around, window);
  cv::dilate(rarity, rarity, window);
  return seen;
}

struct Change {
  bool known = false;  // already outlined at a finer scale
  float peak = 0.0F;   // in deviations
};

// Calls `work` with the pixel within the sighting, the pixel in the whole image, and the blob.
template <typename Work>
void for_each_pixel(const Sighting& seen, const Blobs& blobs, const Work& work) {
  for (const Run& run : blobs.runs()) {
    for (int u = run.first; u < run.end; ++u)
      work(cv::Point(u, run.v), cv::Point(seen.where.x + u, seen.where.y + run.v), run.blob);
  }
}

}  // namespace

Outlines::Outlines(const Mask& unreliable, double tests, Comparison& comparison)
    : unreliable_(unreliable),
      log10_tests_(std::log10(tests)),
      comparison_(comparison),
      outlined_{Mask(unreliable.width(), unreliable.height()),
                Mask(unreliable.width(), unreliable.height())} {}

void Outlines::add(const Scale& scale, const Image<float>& evidence) {
  for (const float sign : {1.0F, -1.0F}) add(scale, evidence, sign);
}

void Outlines::add(const Scale& scale, const Image<float>& evidence, float sign) {
  const Sighting seen = sighting(scale, unreliable_, log10_tests_, sign);
  if (seen.where.empty()) return;
  Mask& outlined = outlined_[sign > 0.0F ? 0 : 1];
  const std::uint8_t farther = sign > 0.0F ? std::uint8_t{0} : mask_set;
  const Blobs blobs(seen.around);
  std::vector<Change> changes(blobs.count());
  for_each_pixel(seen, blobs, [&](const cv::Point&, const cv::Point& at, std::size_t blob) {
    Change& change = changes[blob];
    change.known = change.known || outlined(at.x, at.y) != 0;
    change.peak = std::max(change.peak, sign * scale.evidence.deviations(at.x, at.y));
  });
  const auto half = static_cast<float>(0.5 * scale.evidence.spread / scale.evidence.window_px);
  for_each_pixel(seen, blobs, [&](const cv::Point& here, const cv::Point& at, std::size_t blob) {
    const float rarity = seen.rarity(here.x, here.y);
    outlined(at.x, at.y) = mask_set;
    if (comparison_.changed(at.x, at.y) != 0) {
      // A change of the other kind found at another scale is not made rarer by this one.
      if (comparison_.farther(at.x, at.y) == farther)
        comparison_.evidence(at.x, at.y) = std::max(comparison_.evidence(at.x, at.y), rarity);
    } else if (!changes[blob].known && sign * evidence(at.x, at.y) > half * changes[blob].peak) {
      comparison_.changed(at.x, at.y) = mask_set;
      comparison_.farther(at.x, at.y) = farther;
      comparison_.evidence(at.x, at.y) = rarity;
    }
  });
}

}  // namespace rva
