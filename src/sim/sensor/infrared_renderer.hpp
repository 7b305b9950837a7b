// The light on the two infrared imagers, before any noise.
#pragma once

#include "depth/image.hpp"
#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"
#include "sim/sensor/dot_pattern.hpp"
#include "sim/sensor/rectification_error.hpp"
#include "sim/sensor/stereo_rig.hpp"

namespace rva {

/// Light on one imager, by source. The unit is the light from a white, matt surface that faces the projector
/// at a distance of 1 m, in the projector's mean light.
struct ImagerLight {
  Image<float> steady;     ///< ambient light, lamps and interreflections
  Image<float> projected;  ///< direct laser light of the projector, which is subject to speckle
};

/// Light on both imagers at one time.
struct InfraredPair {
  ImagerLight left;   ///< on the left imager
  ImagerLight right;  ///< on the right imager
};

/// The light that camera and robot give off.
struct OwnLight {
  bool projector = true;  ///< whether dots are projected
  double lamp = 0.0;      ///< share of the full light of the lamp beside the imagers, 0 to 1
  bool operator==(const OwnLight&) const = default;
};

/// The truth at the centre of each pixel of the depth (left) imager.
struct TrueView {
  Image<float> depth_m;  ///< along z; 0 where there is no surface
  LabelImage labels;     ///< Scene::label_of(); 0 where there is no surface
};

/// Renders one scene from any pose. Calls are const and use all cores; render() throws Interrupted when the
/// user stops the program.
class InfraredRenderer {
 public:
  /// @param rays the ray caster of `scene`; both must outlive the renderer
  InfraredRenderer(const Scene& scene, const RayCaster& rays, const StereoSensorOptions& options);

  /// Renders both imagers with `supersampling` squared rays per pixel, shadows of the projector and of lamps,
  /// and the blur of the lenses.
  /// @param light lamps of the scene are always on
  [[nodiscard]] InfraredPair render(const Transform& world_from_camera, const Misalignment& misalignment,
                                    int supersampling, const OwnLight& light = {}) const;

  /// The truth for a pose, with one ray per pixel.
  [[nodiscard]] TrueView true_view(const Transform& world_from_camera) const;

 private:
  struct Eye;
  class RowShader;
  [[nodiscard]] ImagerLight render_eye(const Eye& eye, const Transform& world_from_camera, int supersampling,
                                       const OwnLight& light) const;

  const Scene& scene_;
  const RayCaster& rays_;
  StereoRig rig_;
  DotPattern dots_;
  RectificationError left_error_;
  RectificationError right_error_;
  double lens_blur_px_;
  double bounce_;
  double lamp_light_;
};

}  // namespace rva
