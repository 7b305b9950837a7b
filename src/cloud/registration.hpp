// Where the camera stood after the work, seen from where it stood before: registration on depth images.
#pragma once

#include <string>

#include "cloud/depth_view.hpp"
#include "cloud/registration_uncertainty.hpp"
#include "core/error.hpp"
#include "geometry/transform.hpp"

namespace rva {

struct Registration {
  Transform initial_from_final = Transform::Identity();
  /// Of a small rotation vector (rad) and translation (m) in the initial camera's frame, in this order.
  PoseCovariance covariance = PoseCovariance::Zero();
  double offset_px = 0.0;  ///< disparity of the initial view against the final one: drift of temperature
  double agreeing = 0.0;   ///< share of what could be compared that lies where the other view has a surface
  double overlap = 0.0;    ///< share of the views that could be compared
  /// Empty where the transform is to be trusted; else why not, for a person.
  std::string doubt;

  [[nodiscard]] bool trusted() const { return doubt.empty(); }
};

/// Thrown where a comparison needs views laid over each other and their registration is not to be trusted.
class RegistrationRefused : public Error {
 public:
  using Error::Error;
};

/// Where to begin.
struct RegistrationGuess {
  Transform initial_from_final = Transform::Identity();
  bool nearby = false;  ///< within a few centimetres and degrees: no other place is tried
};

/// Projective point to plane registration (Blais and Levine 1995; Chen and Medioni 1992) in disparity, coarse
/// to fine, both ways at once, with Tukey's biweight against what changed and what one view alone sees. It
/// begins at many places around the guess, since stringers repeat and a single start slides along them.
[[nodiscard]] Registration register_views(const DepthView& initial, const DepthView& final,
                                          const RegistrationGuess& guess = {});

}  // namespace rva
