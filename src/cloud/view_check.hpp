// Whether two views may be compared pixel by pixel.
#pragma once

#include <optional>

#include "cloud/depth_view.hpp"
#include "cloud/registration.hpp"
#include "cloud/view_motion.hpp"

namespace rva {

/// What the depth images of two captures of one camera show of a motion in between.
struct ViewCheck {
  ViewMotion motion;
  /// Where much differs, of a motion that may be too large for `motion`.
  std::optional<Registration> registration;
  double registered_px = 0.0;  ///< the displacement in the image that the registration found

  /// True where nothing shows that the camera moved.
  [[nodiscard]] bool is_aligned() const;
  /// True where no small motion explains what differs.
  [[nodiscard]] bool shows_other_view() const;

 private:
  [[nodiscard]] bool moved_far() const;
};

[[nodiscard]] ViewCheck check_views(const DepthView& initial, const DepthView& final);

/// How far apart two places put what a view shows, in the image of the camera there: root mean square, px.
[[nodiscard]] double displacement_px(const DepthView& view, const Transform& camera_from_view,
                                     const Transform& other);

/// Registration of views that are meant to lie over each other: nearby first, then anywhere.
[[nodiscard]] Registration register_near_views(const DepthView& initial, const DepthView& final);

}  // namespace rva
