// How closely a camera has come back to where each capture of a baseline was taken.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "depth/capture.hpp"

namespace rva {

/// The poses of the captures of one view's baseline, as later images of the same camera show them.
///
/// Two estimates are made, and the larger one counts. The depth images show it by their edges
/// (view_motion()). The left infrared image is laid, without its dots, upon those of all other captures of
/// the baseline (infrared/infrared_alignment.hpp), and so was the capture's own. What both estimates have in
/// common is that they are too small rather than too large: the matcher's errors and the light between the
/// dots stay where they are in the image when the camera turns. For the same reason the capture's own image
/// is left out of what its pose is measured against.
class BaselinePoses {
 public:
  /// @param captures of one view, dithered, at least one; outlive this object
  /// @throws Error when an image cannot be read
  explicit BaselinePoses(const Captures& captures);
  ~BaselinePoses();
  BaselinePoses(const BaselinePoses&) = delete;
  BaselinePoses& operator=(const BaselinePoses&) = delete;

  /// @param capture  by its position in the baseline
  /// @param returned what the camera sees now: a few frames, of the same intrinsics
  /// @return by how much the camera is turned from where that capture was taken, in degrees; empty where
  ///         nothing in view shows it, or the lens bends rays
  /// @throws Error when an image cannot be read
  [[nodiscard]] std::optional<double> turn_deg(std::size_t capture, const Capture& returned);

 private:
  class Infrared;

  const Captures& captures_;
  std::unique_ptr<Infrared> infrared_;  // null where a capture lacks infrared images, or there are too few
};

}  // namespace rva
