#include "detect/spatial/lit_capture.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "capture/capture_view.hpp"
#include "core/parallel.hpp"
#include "detect/findings/detection.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/projector_field.hpp"

namespace rva {
namespace {

/// A capture whose depth is set to 0 within a mask.
class LitCapture : public CaptureView {
 public:
  /// @param beyond mask of the size of the depth images, or empty
  LitCapture(const Capture& whole, Mask beyond)
      : CaptureView(whole, whole.info()), beyond_(std::move(beyond)) {}

  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    DepthImage image = CaptureView::depth(i);
    for (std::size_t pixel = 0; pixel < beyond_.size(); ++pixel) {
      if (beyond_[pixel] != 0) image[pixel] = 0;
    }
    return image;
  }

 private:
  Mask beyond_;
};

Mask without_projector(const Capture& capture) {
  constexpr int beside_px = 10;  // beside the last dots, half of a window has none
  const std::optional<Image<float>> grey = capture.infrared_mean(Imager::left, Light::projector);
  if (!grey) return {};
  const Image<float> log_image = log_grey(*grey);
  return beyond_projector(log_image, dot_mask(log_image), beside_px);
}

std::vector<Mask> without_projector(const Captures& captures) {
  std::vector<Mask> masks(captures.size());
  parallel_bands(static_cast<int>(captures.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      masks[k] = without_projector(*captures[k]);
  });
  return masks;
}

void join(Mask& a, Mask& b) {
  if (a.width() != b.width() || a.height() != b.height()) return;
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] = a[i] | b[i];
}

Captures lit(const Captures& captures, std::vector<Mask> beyond) {
  Captures all;
  for (std::size_t k = 0; k < captures.size(); ++k)
    all.push_back(std::make_unique<LitCapture>(*captures[k], std::move(beyond[k])));
  return all;
}

}  // namespace

LitSides within_projector_field(const Captures& initial, const Captures& final) {
  std::vector<Mask> before = without_projector(initial);
  std::vector<Mask> after = without_projector(final);
  for (std::size_t k = 0; k < std::min(initial.size(), final.size()); ++k) {
    if (!poses_differ(initial[k]->info(), final[k]->info())) join(before[k], after[k]);
  }
  return {lit(initial, std::move(before)), lit(final, std::move(after))};
}

}  // namespace rva
