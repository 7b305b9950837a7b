// A wrapper of a capture that passes on whatever a derived class does not override.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "capture/capture.hpp"

namespace rva {

/// Passes on everything of another capture, which must outlive it. Derived classes override what differs.
class CaptureView : public Capture {
 public:
  /// @param info in place of the other capture's
  CaptureView(const Capture& whole, CaptureInfo info) : Capture(std::move(info)), whole_(whole) {}

  [[nodiscard]] std::size_t depth_frames() const override { return whole_.depth_frames(); }
  [[nodiscard]] std::size_t color_frames() const override { return whole_.color_frames(); }
  [[nodiscard]] DepthImage depth(std::size_t i) const override { return whole_.depth(i); }
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
};

/// Whether two depth units are equal to within one part in a million, as programs round them differently.
[[nodiscard]] bool is_same_unit(double a_m, double b_m);

/// The capture with its depth rounded to another unit; depth that does not fit into 16 bits becomes no_depth.
/// @param capture must outlive the result
/// @param unit_m  metres, above 0
[[nodiscard]] std::unique_ptr<Capture> in_unit(const Capture& capture, double unit_m);

}  // namespace rva
