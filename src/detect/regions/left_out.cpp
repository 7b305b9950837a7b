#include "detect/regions/left_out.hpp"

#include <cmath>

#include "core/parallel.hpp"

namespace rva {
namespace {

// The mask at the projection of a point; 0 if it does not project onto the initial image.
std::uint8_t mask_at(const Mask& left_out, const Intrinsics& initial, const Eigen::Vector3d& point) {
  if (point.z() <= 0.0) return 0;
  const Eigen::Vector2d pixel = initial.project(point);
  if (!initial.contains(pixel)) return 0;
  return left_out(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
}

}  // namespace

Mask carry_over(const Mask& left_out, const Intrinsics& initial, const Intrinsics& final,
                const Image<float>& final_m, const Transform& initial_from_final) {
  if (initial == final && initial_from_final.isApprox(Transform::Identity(), 1e-12)) return left_out;
  Mask carried(final.width, final.height);
  const auto carry_row = [&](int v) {
    for (int u = 0; u < final.width; ++u) {
      if (final_m(u, v) <= 0.0F) continue;
      const Eigen::Vector3d point = final.deproject({u, v}, static_cast<double>(final_m(u, v)));
      carried(u, v) = mask_at(left_out, initial, initial_from_final * point);
    }
  };
  parallel_bands(final.height, [&](int first, int end) {
    for (int v = first; v < end; ++v) carry_row(v);
  });
  return carried;
}

}  // namespace rva
