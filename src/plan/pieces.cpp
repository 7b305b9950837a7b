#include "plan/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/quantile.hpp"
#include "core/units.hpp"
#include "detect/findings/height_above_surroundings.hpp"
#include "detect/regions/regions.hpp"

namespace rva {
namespace {

constexpr double join_px = 3.0;

std::optional<double> median(std::vector<float> values) {
  return values.empty() ? std::nullopt : std::optional<double>(quantile(values, 0.5));
}

void measure_surroundings(const Detection& detection, const Intrinsics& camera, Piece& piece) {
  if (piece.kind == ChangeKind::appearance) return;
  const BeforeAndAfter depth = piece.kind == ChangeKind::added
                                   ? BeforeAndAfter{detection.final_m, detection.initial_m}
                                   : BeforeAndAfter{detection.initial_m, detection.final_m};
  const auto height = height_above_surroundings(piece.pixels, depth, detection.changed, camera);
  if (height) piece.above_surroundings_mm = height->median_mm;
}

void measure_depth(const Detection& detection, Piece& piece) {
  std::vector<float> depths_m;
  std::vector<float> heights_m;
  std::vector<float> levels_mm;
  for (const std::uint32_t i : piece.pixels) {
    const float before_m = detection.initial_m[i];
    const float after_m = detection.final_m[i];
    if (after_m > 0.0F || before_m > 0.0F) depths_m.push_back(after_m > 0.0F ? after_m : before_m);
    if (after_m > 0.0F && before_m > 0.0F) heights_m.push_back(before_m - after_m);
    if (detection.level_of_detection && !std::isnan(detection.level_of_detection->least_mm[i]))
      levels_mm.push_back(detection.level_of_detection->least_mm[i]);
  }
  piece.depth_m = median(std::move(depths_m));
  if (2 * heights_m.size() >= piece.pixels.size())
    piece.height_mm = mm_per_m * median(std::move(heights_m)).value();
  piece.level_mm = median(std::move(levels_mm));
}

// A single pixel without depth is taken to be as far as the whole piece.
void place_in_baseline(const BaselineView& baseline, int width, Piece& piece) {
  for (const std::uint32_t i : piece.pixels) {
    const Eigen::Vector2d pixel(static_cast<int>(i) % width, static_cast<int>(i) / width);
    if (const auto seen = baseline.at(pixel, piece.depth_m)) piece.outline.push_back(*seen);
  }
  if (piece.outline.empty()) return;
  Eigen::Vector2d sum(0.0, 0.0);
  for (const Eigen::Vector2d& pixel : piece.outline) sum += pixel;
  piece.centroid = sum / static_cast<double>(piece.outline.size());
}

}  // namespace

std::vector<Piece> pieces_of(const Detection& detection, const BaselineView& baseline) {
  const int width = detection.final_m.width();
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < detection.findings.findings.size(); ++k) {
    const Finding& finding = detection.findings.findings[k];
    Mask mask(width, detection.final_m.height());
    for (const std::uint32_t i : finding.pixels) mask[i] = mask_set;
    for (Region& region : find_regions(mask, {.join_px = join_px})) {
      Piece piece;
      piece.finding = k;
      piece.kind = finding.kind;
      piece.box = region.box;
      piece.pixels = std::move(region.pixels);
      measure_depth(detection, piece);
      measure_surroundings(detection, baseline.final_camera(), piece);
      place_in_baseline(baseline, width, piece);
      pieces.push_back(std::move(piece));
    }
  }
  std::ranges::sort(pieces, {}, [](const Piece& piece) { return std::tie(piece.kind, piece.pixels); });
  return pieces;
}

}  // namespace rva
