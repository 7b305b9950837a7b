// How closely a camera has come back to where each capture of a baseline was taken.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "capture/capture.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// The poses of the captures of one view's baseline, as later images of the same camera show them.
///
/// A turn is estimated twice, and the larger estimate counts: from the depth images (view_motion()), and from
/// the left infrared image, which is aligned without its dots with those of all other captures of the
/// baseline (infrared/infrared_alignment.hpp), as the capture's own image is. The matcher's errors and the
/// light between the dots stay where they are in the image when the camera turns, which makes turns seem
/// smaller. For this reason the larger estimate counts, and the capture's own image is not among those that
/// it is aligned with. docs/robot.md states how close the estimates are.
class BaselinePoses {
 public:
  /// @param captures of one view, dithered, at least one; outlive this object
  /// @throws Error when an image cannot be read
  explicit BaselinePoses(const Captures& captures);
  ~BaselinePoses();
  BaselinePoses(const BaselinePoses&) = delete;
  BaselinePoses& operator=(const BaselinePoses&) = delete;

  /// Compares the camera's pose with that of a capture of the baseline.
  /// @param capture  by its position in the baseline
  /// @param returned what the camera sees now: a few frames, of the same intrinsics
  /// @return by how much the camera is turned from where that capture was taken, in degrees; empty where
  ///         nothing in view shows it, or the lens bends rays
  /// @throws Error when an image cannot be read
  [[nodiscard]] std::optional<double> turn_deg(std::size_t capture, const Capture& returned);

 private:
  class Infrared;

  [[nodiscard]] const DepthView& depth_of(std::size_t capture);

  const Captures& captures_;
  std::vector<std::optional<DepthView>> depth_;  // of the captures that were asked for
  std::unique_ptr<Infrared> infrared_;  // null where a capture lacks infrared images, or there are too few
};

}  // namespace rva
