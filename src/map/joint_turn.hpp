// Measures from pictures by how much the joints of a robot have turned its camera.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "depth/image.hpp"
#include "geometry/pan_tilt.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// A turn of the camera: by the robot's joints, and what of it the joints cannot cause.
struct JointTurn {
  double pan_deg = 0.0;      ///< of the first joint, positive to the left
  double tilt_deg = 0.0;     ///< of the second joint, positive up
  double rest_deg = 0.0;     ///< about the axis square to both joints: a camera or foot that is loose
  double correlation = 0.0;  ///< of both pictures after the turn is undone, -1 to 1
};

/// Pictures that agree less show different views, or nothing but noise.
inline constexpr double least_correlation = 0.3;

/// The imager that takes the pictures.
struct PictureImager {
  Intrinsics camera;                             ///< with or without lens distortion
  Transform from_depth = Transform::Identity();  ///< imager_from_depth
};

/// Compares later pictures of one camera with a first one.
///
/// Both are smoothed and freed of what varies over wide distances, so that light that turns with the camera
/// counts little. Gauss-Newton then finds the three angles of a JointTurn, and the change of brightness, by
/// which the first picture becomes the later one, with Tukey's weights, from coarse to fine smoothing. How a
/// pixel moves when a joint turns follows from its depth and the chain of joints, since the camera is beside
/// the axes. The projector's dots must not be in the pictures: they turn with the camera, which makes turns
/// seem smaller.
class JointTurnGauge {
 public:
  /// @param joints  of the first picture, as the robot reports them; an error of some degrees is harmless
  /// @param surface what the depth imager sees from there; not empty
  /// @param first   brightness in any unit, of which the noise should be even: the root of the light
  JointTurnGauge(const PanTiltChain& chain, const PanTilt& joints, const PictureImager& imager,
                 const ReferenceSurface& surface, const Image<float>& first);

  /// @param picture of the same imager and unit, within about three degrees of the first
  /// @return a turn that is meaningless where its correlation is less than least_correlation
  [[nodiscard]] JointTurn turn_to(const Image<float>& picture) const;

 private:
  /// A point that the first picture shows.
  struct Sample {
    Eigen::Vector3d point_m;  // in the depth imager's frame at the first picture
    float brightness = 0.0F;
    Eigen::Vector3f slope_per_deg = Eigen::Vector3f::Zero();  // of brightness, by pan, tilt and the rest
  };
  /// The steepest points of the first picture at one smoothing.
  struct Level {
    double smoothing_px = 0.0;
    std::vector<Sample> samples;
  };
  struct Estimate;
  struct Comparison;

  [[nodiscard]] Level level_of(double smoothing_px, const ReferenceSurface& surface,
                               const Image<float>& first) const;
  [[nodiscard]] Transform imager_from_first(const Eigen::Vector3d& turn_deg) const;
  void improve(const Level& level, const Image<float>& picture, Estimate& estimate) const;

  PanTiltChain chain_;
  PanTilt joints_;
  PictureImager imager_;
  Transform camera_from_foot_;
  Eigen::Vector3d rest_axis_;  // in the depth imager's frame
  std::vector<Level> levels_;  // from coarse to fine
};

}  // namespace rva
