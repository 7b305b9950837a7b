// What a comparison inspected, in the picture of the baseline, on which plans are drawn.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "detect/detect.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// The cameras of a comparison: those of the first capture of either side.
struct ComparedCameras {
  Intrinsics initial;  ///< of the initial depth image
  Intrinsics final;    ///< of the final depth image
};

/// The final surface and the level of detection, transferred to the picture of the baseline through depth.
class BaselineView {
 public:
  /// @param detection in the final view
  BaselineView(const Detection& detection, const ComparedCameras& cameras);

  /// The pixel of the baseline's picture at which a pixel of the final view is seen; empty without a depth
  /// where the camera moved, or behind the baseline's camera.
  /// @param depth_m along z of the final camera, where it is measured
  [[nodiscard]] std::optional<Eigen::Vector2d> at(const Eigen::Vector2d& final_pixel,
                                                  std::optional<double> depth_m) const;

  /// The least height that would have been found about a pixel of the baseline's picture, mm: the lower
  /// quartile around it, since a part is found if any of its pixels shows it; empty where less than a quarter
  /// was inspected. 0 for methods without a level of detection, which inspect
  /// what they measure.
  [[nodiscard]] std::optional<double> level_mm(const Eigen::Vector2d& pixel) const;

  /// Depth after the work along the baseline camera's z, metres; 0 where it is not known.
  [[nodiscard]] const Image<float>& depth_m() const { return depth_m_; }
  /// The least height that would have been found, mm; NaN where nothing was inspected.
  [[nodiscard]] const Image<float>& least_mm() const { return least_mm_; }
  /// The baseline's camera.
  [[nodiscard]] const Intrinsics& camera() const { return cameras_.initial; }
  /// The camera of the final depth image, whose pixels findings have.
  [[nodiscard]] const Intrinsics& final_camera() const { return cameras_.final; }

 private:
  void transfer(const Detection& detection, const Image<float>& least_mm);
  void add(const Eigen::Vector3d& point, float level_mm);

  ComparedCameras cameras_;
  Transform initial_from_final_;
  bool stood_still_;
  Image<float> depth_m_;
  Image<float> least_mm_;
};

}  // namespace rva
