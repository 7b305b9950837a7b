// Calibrates a robot's geometry from views that its camera takes at different joint angles.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/map_view.hpp"
#include "map/overlapping_views.hpp"

namespace rva {

/// Prior standard deviations (one sigma) of the servos' angles and of the given geometry.
struct CalibrationOptions {
  double servo_error_deg = 0.1;  ///< of the angle that a joint reports
  double place_error_mm = 10.0;  ///< of the measured lengths
  double turn_error_deg = 4.0;   ///< of the measured directions

  static void describe(auto&& self, auto&& visit) {
    visit(self.servo_error_deg, OptionField{"servo-error", "deg", 0.001, 10,
                                            "how far a joint may be from the angle it reports (one sigma)"});
    visit(self.place_error_mm,
          OptionField{"place-error", "mm", 0.01, 1000, "error of the measured lengths (one sigma)"});
    visit(self.turn_error_deg,
          OptionField{"turn-error", "deg", 0.01, 30, "error of the measured directions (one sigma)"});
  }
};

/// One parameter of the geometry.
struct CalibratedNumber {
  std::string name;        ///< for the user: "camera, forward"
  std::string unit;        ///< "mm", "deg"
  double change = 0.0;     ///< from the given geometry
  double deviation = 0.0;  ///< one sigma
  bool held = true;        ///< false when the views hardly constrain it
};

/// A view's residuals before and after the calibration.
struct CalibratedView {
  PanTilt joint_error;   ///< estimated error of the servos at this view
  ViewResiduals before;  ///< with the geometry that was given
  ViewResiduals after;   ///< with the estimated geometry
};

/// How well the surfaces of all views coincide, with the given geometry and with the estimated one.
struct CalibrationResiduals {
  ViewResiduals before;  ///< with the geometry that was given
  ViewResiduals after;   ///< with the estimated geometry
};

/// The result of a calibration of the robot's geometry.
struct Calibration {
  PanTiltChain chain;                     ///< the estimated geometry
  std::vector<CalibratedNumber> numbers;  ///< the eight parameters
  std::vector<CalibratedView> views;      ///< in the order of the views given
  /// Empty when the geometry is reliable; otherwise the reason why it is not, for the user.
  std::string doubt;
};

/// Estimates the geometry from all views at once, as refine_poses() does, but the unknowns are the geometry
/// and the servos' errors instead of the poses. What the views do not determine stays as given: the position
/// of the first servo on the foot, the height of the bracket above it, the position of the bracket along its
/// own axis, and the direction of pan 0. Eight parameters remain: how far the tilt axis is in front of the
/// pan axis, how far it leans, and the camera's position (3) and orientation (3) on the bracket.
/// @param views of one robot whose foot did not move, spread over the range of both joints
/// @param given the geometry as it was measured
/// @throws Error when there are fewer than three views, or a joint turns by less than 10 degrees among them;
///         UsageError when an option is out of range; Interrupted
[[nodiscard]] Calibration calibrate(std::span<const MapView> views, const PanTiltChain& given,
                                    const CalibrationOptions& options = {});

/// The residuals summed over all views.
[[nodiscard]] CalibrationResiduals sum_of_residuals(const Calibration& calibration);

/// What `rva calibrate --json` prints. @param views those of the calibration
[[nodiscard]] nlohmann::ordered_json json_of(const Calibration& calibration, std::span<const MapView> views);

}  // namespace rva
