// Approaches a pose of the baseline again until the images show that the camera has come back to it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/options.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/rig.hpp"
#include "views/baseline_poses.hpp"

namespace rva {

/// Options of the return to a baseline's pose.
struct PoseReturnOptions {
  int approaches = 1;        ///< to each pose, at most; 1: the images are not checked
  double within_deg = 0.05;  ///< distance from the baseline's pose that counts as a close return

  static void describe(auto&& self, auto&& visit) {
    visit(self.approaches,
          OptionField{"approaches", "", 1, 50,
                      "approaches to each pose of the baseline after the work, at most, until the images "
                      "show a close return; 1: no check"});
    visit(self.within_deg, OptionField{"return-within", "deg", 0.01, 1,
                                       "distance from the baseline's pose that counts as a close return"});
  }
};

/// The pose that an approach reached.
struct ReachedPose {
  PanTilt joints;                   ///< as the robot reports them
  int approaches = 1;               ///< made
  std::optional<double> off_deg{};  ///< from the baseline's pose; empty where the images do not show it
};

/// Whether the latest approach is the last: it came within `options.within_deg`, or it is the last that is
/// allowed. From half of the approaches on, it is also enough to have come as close as any before, since a
/// pose that the robot has left cannot be reached again at will.
[[nodiscard]] bool is_close_enough(const std::vector<double>& off_deg, const PoseReturnOptions& options);

/// Called after each approach. @param last whether the capture is taken from there
using OnApproach = std::function<void(const ReachedPose& reached, bool last)>;

/// Approaches a waypoint until the camera is close enough to the pose of a capture of the baseline. If the
/// images do not show how close it is, the first approach is the last.
/// @param baseline captures of the same waypoints
/// @param capture  of the baseline, by position
/// @param on_approach may be empty
/// @throws UsageError, Error, Interrupted  as approach(); Error as Camera, or when an image cannot be read
[[nodiscard]] ReachedPose return_to_pose(const Rig& rig, const PanTilt& waypoint, BaselinePoses& baseline,
                                         std::size_t capture, std::size_t settling_frames,
                                         const PoseReturnOptions& options, const OnApproach& on_approach);

}  // namespace rva
