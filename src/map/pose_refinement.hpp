// Where the camera really was at each waypoint: servos say it to a step, and surfaces that several views
// share say it better.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/map_view.hpp"

namespace rva {

/// Deviations (one sigma) that are believed before any view is looked at.
struct RefinementOptions {
  double servo_error_deg = 0.1;
  double place_error_mm = 0.2;
  double turn_error_deg = 0.02;

  static void describe(auto&& self, auto&& visit) {
    visit(self.servo_error_deg, OptionField{"servo-error", "deg", 0.001, 10,
                                            "how far a joint may be from the angle it reports (one sigma)"});
    visit(self.place_error_mm, OptionField{"place-error", "mm", 0.001, 100,
                                           "how far the geometry may put the camera off (one sigma)"});
    visit(self.turn_error_deg, OptionField{"turn-error", "deg", 0.001, 10,
                                           "how far the geometry may turn the camera wrongly (one sigma)"});
  }
};

struct RefinedPose {
  Transform foot_from_camera = Transform::Identity();
  /// What the views would correct the joints by; not done where there is a doubt.
  double moved_mm = 0.0;
  double turned_deg = 0.0;
  int neighbours = 0;        ///< views that share surfaces with this one
  double agreeing = 0.0;     ///< share of what they share that lies on the same surfaces
  double residual_px = 0.0;  ///< root mean square of that share, in disparity
  /// Empty where the pose is to be trusted; else why not, for a person. The pose is then the one by the
  /// joints.
  std::string doubt;
};

/// All poses at once: point to plane residuals of all pairs of overlapping views in disparity, as
/// register_views() has them for one pair (Gauss and Newton with Tukey's biweight, coarse to fine), and what
/// is known beforehand: a servo errs about its own axis much more than the chain of joints errs otherwise.
/// Nothing but that prior holds all views together in the foot's frame.
/// @param views of one robot whose foot stood still
/// @return of each view
[[nodiscard]] std::vector<RefinedPose> refine_poses(std::span<const MapView> views, const PanTiltChain& chain,
                                                    const RefinementOptions& options = {});

}  // namespace rva
