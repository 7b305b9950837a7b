// Heights along a line in a picture.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "measure/quantity.hpp"

namespace rva {

/// What a profile measured at one sample.
struct ProfilePoint {
  double along_mm = 0.0;  ///< from the first end, along the line through both ends
  Quantity height;        ///< above that line, positive towards the camera
};

/// A sample of a profile.
struct ProfileSample {
  double share = 0.0;                 ///< of the line in the picture, from 0 at its first end to 1
  std::optional<ProfilePoint> point;  ///< empty in a gap: where nothing could be measured
};

/// Heights along a line.
struct Profile {
  Quantity length;                     ///< between the ends
  std::vector<ProfileSample> samples;  ///< in order, both ends included; a pixel apart, or more in long lines
};

/// A profile, or why an end of it cannot be measured.
using ProfileOrReason = std::variant<Profile, Unmeasured>;

/// The profile along the line between two pixels of the depth image (equation 86).
/// @return collinear where both ends are the same point
[[nodiscard]] ProfileOrReason profile_along(const UncertainView& view, const Eigen::Vector2d& from,
                                            const Eigen::Vector2d& to, const MeasureOptions& options);

}  // namespace rva
