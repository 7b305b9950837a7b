#include "cloud/left_out.hpp"

#include <cmath>

#include "core/parallel.hpp"

namespace rva {

Mask carry_over(const Mask& left_out, const Intrinsics& initial, const Intrinsics& final,
                const Image<float>& final_m, const Transform& initial_from_final) {
  if (initial == final && initial_from_final.isApprox(Transform::Identity(), 1e-12)) return left_out;
  Mask carried(final.width, final.height);
  parallel_bands(final.height, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < final.width; ++u) {
        if (final_m(u, v) <= 0.0F) continue;
        const Eigen::Vector3d point =
            initial_from_final * final.deproject({u, v}, static_cast<double>(final_m(u, v)));
        if (point.z() <= 0.0) continue;
        const Eigen::Vector2d pixel = initial.project(point);
        if (!initial.contains(pixel)) continue;
        carried(u, v) =
            left_out(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
      }
    }
  });
  return carried;
}

}  // namespace rva
