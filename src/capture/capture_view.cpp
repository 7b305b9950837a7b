#include "capture/capture_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "depth/image.hpp"

namespace rva {
namespace {

class InUnit : public CaptureView {
 public:
  InUnit(const Capture& capture, double unit_m)
      : CaptureView(capture, with_unit(capture.info(), unit_m)),
        factor_(capture.info().depth_unit_m / unit_m) {}

  [[nodiscard]] DepthImage depth(std::size_t i) const override {
    constexpr double most = 65534.0;  // 65535 means no measurement
    DepthImage image = CaptureView::depth(i);
    for (std::uint16_t& units : image.pixels()) {
      const double scaled = std::round(factor_ * units);
      units = scaled > most ? no_depth : static_cast<std::uint16_t>(scaled);
    }
    return image;
  }

 private:
  static CaptureInfo with_unit(CaptureInfo info, double unit_m) {
    info.depth_unit_m = unit_m;
    return info;
  }

  double factor_;
};

}  // namespace

bool is_same_unit(double a_m, double b_m) {
  constexpr double tolerance = 1e-6;
  return std::abs(a_m - b_m) <= tolerance * std::max(a_m, b_m);
}

std::unique_ptr<Capture> in_unit(const Capture& capture, double unit_m) {
  return std::make_unique<InUnit>(capture, unit_m);
}

}  // namespace rva
