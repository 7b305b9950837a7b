// Distance of points from the surfaces of a scene.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "scene/scene.hpp"

namespace rva {

class SurfaceDistance {
 public:
  explicit SurfaceDistance(const Scene& scene);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  SurfaceDistance& operator=(const SurfaceDistance&) = delete;

  /// Distance to the nearest triangle, at most `most_m`.
  /// @param point in the world frame, metres
  [[nodiscard]] double distance_m(const Eigen::Vector3d& point, double most_m) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rva
