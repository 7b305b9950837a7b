// Estimates the pose of the final camera in the frame of the initial one, from depth images.
#pragma once

#include <string>

#include "core/error.hpp"
#include "geometry/transform.hpp"
#include "views/depth_view.hpp"
#include "views/registration_uncertainty.hpp"

namespace rva {

/// The pose of a final view in the frame of an initial one, with its uncertainty.
struct Registration {
  Transform initial_from_final = Transform::Identity();  ///< pose of the final camera
  /// Covariance of a small rotation vector (rad) and translation (m) in the initial camera's frame, in
  /// this order.
  TwistMatrix covariance = TwistMatrix::Zero();
  double offset_px = 0.0;  ///< disparity of the initial view relative to the final one, due to temperature
  double agreeing = 0.0;   ///< share of the compared samples that lie on a surface of the other view
  double overlap = 0.0;    ///< share of the samples that could be compared
  /// Why the transform is not reliable, for the user; empty if it is reliable.
  std::string doubt;

  /// Whether the transform is reliable.
  [[nodiscard]] bool trusted() const { return doubt.empty(); }
};

/// Thrown when a comparison requires registered views and their registration is not reliable.
class RegistrationRefused : public Error {
 public:
  using Error::Error;
};

/// Initial estimate of the pose.
struct RegistrationGuess {
  Transform initial_from_final = Transform::Identity();  ///< where the search starts
  bool nearby = false;  ///< accurate to a few centimetres and degrees: no other start is tried
};

/// Projective point-to-plane registration (Blais and Levine 1995; Chen and Medioni 1992) in disparity, coarse
/// to fine, in both directions at once. Tukey's biweight suppresses changes and surfaces that only one view
/// sees. The search starts from many poses around the guess, since stringers repeat, and from a single start
/// it may converge to a pose shifted by their pitch.
[[nodiscard]] Registration register_views(const DepthView& initial, const DepthView& final,
                                          const RegistrationGuess& guess = {});

}  // namespace rva
