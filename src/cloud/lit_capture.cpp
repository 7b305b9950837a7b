#include "cloud/lit_capture.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "detect/detection.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/projector_field.hpp"

namespace rva {
namespace {

/// A capture whose depth images lack what lies in a mask.
class LitCapture : public Capture {
 public:
  /// @param beyond of the size of the depth images, or empty
  LitCapture(const Capture& whole, Mask beyond)
      : Capture(whole.info()), whole_(whole), beyond_(std::move(beyond)) {}

  [[nodiscard]] std::size_t depth_frames() const override { return whole_.depth_frames(); }
  [[nodiscard]] std::size_t color_frames() const override { return whole_.color_frames(); }
  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    DepthImage image = whole_.depth(i);
    for (std::size_t pixel = 0; pixel < beyond_.size(); ++pixel) {
      if (beyond_[pixel] != 0) image[pixel] = 0;
    }
    return image;
  }
  [[nodiscard]] std::vector<std::string> depth_notes() const override { return whole_.depth_notes(); }
  [[nodiscard]] bool marks_no_depth_by_zero() const override { return whole_.marks_no_depth_by_zero(); }
  [[nodiscard]] ColorImage color(std::size_t i) const override { return whole_.color(i); }
  [[nodiscard]] std::optional<ColorImage> color_of(std::size_t depth_frame) const override {
    return whole_.color_of(depth_frame);
  }
  [[nodiscard]] std::optional<FineGrayImage> infrared_of(std::size_t depth_frame,
                                                         Imager imager) const override {
    return whole_.infrared_of(depth_frame, imager);
  }
  [[nodiscard]] bool has_infrared(Imager imager, Light light) const override {
    return whole_.has_infrared(imager, light);
  }
  [[nodiscard]] std::optional<Image<float>> infrared_mean(Imager imager, Light light) const override {
    return whole_.infrared_mean(imager, light);
  }
  [[nodiscard]] FrameMetadata metadata_of(std::size_t depth_frame) const override {
    return whole_.metadata_of(depth_frame);
  }

 private:
  const Capture& whole_;
  Mask beyond_;
};

Mask without_projector(const Capture& capture) {
  constexpr int beside_px = 10;  // Beside the last dots, half of a window has none.
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
