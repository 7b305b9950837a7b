// Checks whether two views may be compared pixel by pixel.
#pragma once

#include <optional>

#include "views/depth_view.hpp"
#include "views/registration.hpp"
#include "views/view_motion.hpp"

namespace rva {

/// Motion of a camera between two captures, according to their depth images.
struct ViewCheck {
  ViewMotion motion;  ///< motion near the identity
  /// Registration if much of the view differs, for motions too large for `motion`.
  std::optional<Registration> registration;
  double registered_px = 0.0;  ///< displacement in the image according to the registration

  /// True if nothing indicates that the camera moved.
  [[nodiscard]] bool is_aligned() const;
  /// True if no small motion explains the differences.
  [[nodiscard]] bool shows_other_view() const;

 private:
  [[nodiscard]] bool moved_far() const;
};

/// Checks views that are meant to be of one pose.
[[nodiscard]] ViewCheck check_views(const DepthView& initial, const DepthView& final);

/// Distance in the image between the projections of a view for two poses: root mean square, px.
[[nodiscard]] double displacement_px(const DepthView& view, const Transform& camera_from_view,
                                     const Transform& other);

/// Registers views that are meant to be aligned: first near the identity, then anywhere.
[[nodiscard]] Registration register_near_views(const DepthView& initial, const DepthView& final);

}  // namespace rva
