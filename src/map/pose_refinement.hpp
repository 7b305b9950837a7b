// Refines the camera's poses at the waypoints: the servos report angles to one step, and surfaces that
// several views share determine the poses more precisely.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/map_view.hpp"

namespace rva {

/// Prior standard deviations (one sigma) of the servos' angles and of the geometry.
struct RefinementOptions {
  double servo_error_deg = 0.1;  ///< of the angle that a joint reports, one sigma
  double place_error_mm = 0.2;   ///< of the camera's position by the geometry, one sigma
  double turn_error_deg = 0.02;  ///< of the camera's direction by the geometry, one sigma

  static void describe(auto&& self, auto&& visit) {
    visit(self.servo_error_deg, OptionField{"servo-error", "deg", 0.001, 10,
                                            "how far a joint may be from the angle it reports (one sigma)"});
    visit(self.place_error_mm, OptionField{"place-error", "mm", 0.001, 100,
                                           "error of the camera's position from the geometry (one sigma)"});
    visit(self.turn_error_deg, OptionField{"turn-error", "deg", 0.001, 10,
                                           "error of the camera's direction from the geometry (one sigma)"});
  }
};

/// A view's pose after refinement, and how reliable it is.
struct RefinedPose {
  Transform foot_from_camera = Transform::Identity();  ///< the refined pose, or the one given by the joints
  /// The correction of the pose according to the views; it is not applied when there is a doubt.
  double moved_mm = 0.0;
  double turned_deg = 0.0;   ///< angle of the correction
  int neighbours = 0;        ///< number of views that share surfaces with this one
  double agreeing = 0.0;     ///< share of the common samples that lie on the same surfaces
  double residual_px = 0.0;  ///< root mean square residual of these in disparity
  /// Empty when the pose is reliable; otherwise the reason why it is not, for the user. The pose is then the
  /// one given by the joints.
  std::string doubt;
};

/// Refines all poses at once. Minimises the point-to-plane residuals of all pairs of overlapping views in
/// disparity, as register_views() does for one pair (Gauss-Newton with Tukey's biweight, coarse to fine),
/// together with a prior: the error of a servo about its own axis is much larger than the other errors of the
/// geometry. Only this prior ties the views to the foot's frame.
/// @param views of one robot whose foot did not move
/// @return the pose of each view
/// @throws UsageError when an option is out of range; Interrupted
[[nodiscard]] std::vector<RefinedPose> refine_poses(std::span<const MapView> views, const PanTiltChain& chain,
                                                    const RefinementOptions& options = {});

}  // namespace rva
