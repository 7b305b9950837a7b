// What falls on the two infrared imagers, before any noise.
#pragma once

#include "depth/capture.hpp"
#include "depth/image.hpp"
#include "sim/scene/ray_caster.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/dot_pattern.hpp"
#include "sim/sensor/rectification_error.hpp"
#include "sim/sensor/stereo_rig.hpp"

namespace rva {

/// Light on one imager, by where it comes from. A white, matt surface that faces the projector at 1 m, in its
/// mean light, gives 1.
struct ImagerLight {
  Image<float> steady;     ///< ambient light, lamps and what bounces about
  Image<float> projected;  ///< straight from the projector: this is laser light, and speckles
};

struct InfraredPair {
  ImagerLight left;
  ImagerLight right;
};

/// What is really there, at the centre of each pixel of the depth (left) imager.
struct TrueView {
  Image<float> depth_m;         ///< along z; 0 where there is nothing
  Image<std::uint16_t> labels;  ///< Scene::label_of(); 0 where there is nothing
};

/// Renders poses of one scene. Calls are const and use all cores; render() throws Interrupted when a person
/// stops the program meanwhile.
class InfraredRenderer {
 public:
  /// The scene and the caster of its triangles must outlive the renderer.
  InfraredRenderer(const Scene& scene, const RayCaster& rays, const StereoSensorOptions& options);

  /// Rays at `supersampling` squared a pixel, shadows of the projector and of lamps, blur of the lenses.
  /// @param light the camera's own; lamps of the scene are always on
  [[nodiscard]] InfraredPair render(const Transform& world_from_camera, const Misalignment& misalignment,
                                    int supersampling, Light light = Light::projector) const;

  [[nodiscard]] TrueView look(const Transform& world_from_camera) const;

 private:
  struct Eye;
  class RowShader;
  [[nodiscard]] ImagerLight render_eye(const Eye& eye, const Transform& world_from_camera, int supersampling,
                                       Light light) const;

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
