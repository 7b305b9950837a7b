// Where a robot's joints and its camera are, from what the camera sees while the joints turn.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/map_view.hpp"
#include "map/overlapping_views.hpp"

namespace rva {

/// Deviations (one sigma) that are believed before any view is looked at.
struct CalibrationOptions {
  double servo_error_deg = 0.1;
  double place_error_mm = 10.0;
  double turn_error_deg = 4.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.servo_error_deg, OptionField{"servo-error", "deg", 0.001, 10,
                                            "how far a joint may be from the angle it reports (one sigma)"});
    visit(self.place_error_mm, OptionField{"place-error", "mm", 0.01, 1000,
                                           "how far off the measured lengths may be (one sigma)"});
    visit(self.turn_error_deg, OptionField{"turn-error", "deg", 0.01, 30,
                                           "how far off the measured directions may be (one sigma)"});
  }
};

/// One number of the geometry.
struct CalibratedNumber {
  std::string name;        ///< for a person: "camera, forward"
  std::string unit;        ///< "mm", "deg"
  double change = 0.0;     ///< against what was measured before
  double deviation = 0.0;  ///< one sigma
  bool held = true;        ///< false: the views say little of it
};

struct CalibratedView {
  PanTilt joint_error;   ///< by which the servos probably err at this view
  ViewAgreement before;  ///< with the geometry that was given
  ViewAgreement after;
};

struct Calibration {
  PanTiltChain chain;
  std::vector<CalibratedNumber> numbers;
  std::vector<CalibratedView> views;
  /// Empty where the geometry is to be trusted; else why not, for a person.
  std::string doubt;
};

/// All views at once, as refine_poses(), but the unknowns are the geometry and the servos' errors instead of
/// poses. What no camera on the robot can see stays as given: where the first servo stands on the foot, the
/// height of the bracket above it, its place along its own axis and the direction that is called pan 0. Left
/// are eight numbers: how far the tilt axis is in front of the pan axis, how far it leans, and the camera's
/// place and direction on the bracket.
/// @param views of one robot whose foot stood still, all over the reach of both joints
/// @param given the geometry as it was measured
/// @throws Error where there are fewer than three views, or a joint has not turned by 10 degrees at least
[[nodiscard]] Calibration calibrate(std::span<const MapView> views, const PanTiltChain& given,
                                    const CalibrationOptions& options = {});

}  // namespace rva
