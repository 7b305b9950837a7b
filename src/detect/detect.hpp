// Entry point of all detection methods: chooses the method, after checking in the images whether the
// camera moved.
#pragma once

#include <optional>

#include "core/enum_names.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/image.hpp"
#include "detect/findings/detection.hpp"
#include "detect/method.hpp"
#include "detect/spatial/spatial_detection.hpp"
#include "detect/static_detection.hpp"
#include "detect/thesis/octree_detection.hpp"
#include "views/registration.hpp"

namespace rva {

/// Options of detect(), for every method.
struct DetectOptions {
  DetectionMethod method = DetectionMethod::automatic;
  StaticDetectionOptions static_camera;  ///< method is ignored; false findings and regions apply to all
  OctreeOptions octree;

  static void describe(auto&& self, auto&& visit) {
    StaticDetectionOptions::describe(self.static_camera, visit);
    OctreeOptions::describe(self.octree, visit);
  }
};

/// The result of detect() with the registration of the two sides.
struct SidesDetection {
  Detection detection;  ///< in the view of the first final capture
  /// Registration of the first captures of either side; empty if they were not registered.
  std::optional<Registration> registration;
};

/// Compares two sides of one or more captures each.
///
/// The method `automatic` uses `spatial` for several captures a side, and if the stated poses differ.
/// Otherwise it compares pixel by pixel with `calibrated` and checks in the depth images whether the views
/// are aligned (view_motion.hpp). If they are not, it registers them and compares with `spatial`, and a
/// warning states the motion. A static method requested by name is always used; if the camera moved, a
/// warning states that the result may show the motion rather than changes.
/// @param initial, final at least one capture each, those of a side from nearly one pose
/// @param left_out       pixels of the first initial depth image to leave out; empty for none
/// @throws Error when a capture is a copy of another one, or is of a camera that was frozen
///         (genuine_captures.hpp); when the captures are of different cameras or show different views, when
///         they cannot be registered, or a frame cannot be read; UsageError for options out of range;
///         Interrupted
[[nodiscard]] SidesDetection detect(const Captures& initial, const Captures& final,
                                    const DetectOptions& options, const Progress& progress,
                                    const Mask& left_out = {});

}  // namespace rva
