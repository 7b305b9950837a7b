// One door to every detector: which method compares the captures, after the images have shown whether the
// camera moved.
#pragma once

#include <optional>
#include <string_view>

#include "cloud/octree_detection.hpp"
#include "cloud/registration.hpp"
#include "cloud/spatial_detection.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/image.hpp"
#include "detect/detection.hpp"
#include "detect/static_detection.hpp"

namespace rva {

enum class DetectionMethod {
  automatic,   ///< calibrated where the camera stood still, spatial where it moved
  constant,    ///< static camera: the thesis' algorithm 2
  gaussian,    ///< static camera: the thesis' algorithm 3
  calibrated,  ///< static camera: against the noise that the captures show
  spatial,     ///< moved camera: by space that was seen through
  octree,      ///< moved camera: the thesis' pipeline
};
[[nodiscard]] std::string_view name_of(DetectionMethod method);
[[nodiscard]] std::optional<DetectionMethod> detection_method_from_name(std::string_view name);

struct DetectOptions {
  DetectionMethod method = DetectionMethod::automatic;
  StaticDetectionOptions static_camera;  ///< its method is not used; false findings and regions hold for all
  OctreeOptions octree;

  static void describe(auto&& self, auto&& visit) {
    StaticDetectionOptions::describe(self.static_camera, visit);
    OctreeOptions::describe(self.octree, visit);
  }
};

struct SidesDetection {
  Detection detection;  ///< in the view of the first final capture
  std::optional<Registration>
      registration;  ///< of the first captures of either side, where they were registered
};

/// Compares two sides of one capture and more.
///
/// `automatic` believes poses that say that the camera was moved, and several captures a side, and goes to
/// `spatial`. Otherwise it compares pixel by pixel with `calibrated` and checks from the depth images whether
/// the views lie over each other (view_motion.hpp). Where they do not, it registers them and compares with
/// `spatial`, and a warning states the motion. A static method that was asked for by name is used in any
/// case; then the warning says that its result may show the motion rather than changes.
/// @param initial, final at least one capture each, those of a side from nearly one place
/// @param left_out       pixels of the first initial depth image that a person wants left out; empty for none
/// @throws Error when the captures are of different cameras or show different places, when they cannot be
///         registered, or a frame cannot be read; UsageError for options out of range; Interrupted
[[nodiscard]] SidesDetection detect(const Captures& initial, const Captures& final,
                                    const DetectOptions& options, const Progress& progress,
                                    const Mask& left_out = {});

}  // namespace rva
