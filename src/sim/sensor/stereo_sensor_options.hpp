// The settings of the simulated depth camera, with defaults and units. docs/simulator.md gives their sources
// and the effect of each on depth.
#pragma once

#include <cstdint>

#include "core/enum_names.hpp"
#include "core/options.hpp"

namespace rva {

/// How the camera's processor finds disparities.
enum class Matcher {
  /// Census costs in a window, least squares for the subpixel part (block_matching.hpp, subpixel.hpp).
  census,
  /// Census costs along paths, a parabola for the subpixel part (semi_global.hpp).
  semi_global,
  /// Differences of brightness in a window, a parabola for the subpixel part (correlation.hpp).
  correlation,
};
/// The names that the files of simulated captures use.
template <>
inline constexpr auto enum_names<Matcher> = std::to_array<EnumName<Matcher>>({
    {Matcher::census, "census"},
    {Matcher::semi_global, "semi-global"},
    {Matcher::correlation, "correlation"},
});

/// A stereo depth camera with a dot projector. Defaults are those of a D435 at 848 x 480.
struct StereoSensorOptions {
  // Optics
  double focal_px = 425.0;        ///< focal length of both infrared imagers
  double baseline_mm = 50.0;      ///< distance between the imagers
  double lens_blur_px = 0.6;      ///< standard deviation of the lenses' blur
  double misalignment_px = 0.1;   ///< how far rows of the imagers are apart, at the image's edges
  double rectification_px = 0.0;  ///< standard deviation of what calibration leaves, slowly varying
  int supersampling = 2;          ///< rays per pixel along each side
  // Projector
  int dots = 5000;          ///< dots of the projector
  double dot_share = 0.8;   ///< share of the projector's light that is in dots
  double bounce = 0.05;     ///< projector light that arrives from other surfaces, relative to its mean at 1 m
  double lamp_light = 1.0;  ///< light of the lamp beside the imagers, at 1 m; 0: there is none
  // Imager
  double exposure = 0.0;  ///< electrons for a white surface in the projector's mean light at 1 m; 0 sets it
                          ///< by the view, as the camera does on its own
  double exposure_target = 0.25;   ///< of the brighter parts under automatic exposure; 1 saturates
  double gain = 1.0;               ///< of the imagers' signal: how many times earlier a pixel saturates
  double imager_difference = 0.0;  ///< how much more light the right imager records; -0.1 is a tenth less
  double full_well_e = 1500.0;     ///< electrons at which a pixel saturates
  double read_noise_e = 6.0;       ///< electrons of noise without light
  // Noise that is correlated between pixels, frames or captures
  double speckle = 0.12;          ///< contrast of laser speckle that stays while nothing moves
  double speckle_turn_deg = 0.0;  ///< turn that changes speckle into another; 0: the least motion does
  double wander = 0.05;           ///< contrast of speckle that wanders slowly
  double wander_frames = 50.0;    ///< frames over which that speckle wanders
  double levels = 0.04;           ///< contrast of speckle that jumps between three patterns
  double level_frames = 150.0;    ///< frames for which one of these patterns persists, on average
  double flicker = 0.01;          ///< standard deviation of the exposure from frame to frame
  double drift_px = 0.05;  ///< standard deviation of the disparity's offset between captures (temperature)
  double sway_mm = 0.0;  ///< standard deviation of the camera's position in a bay that gives way, along each
                         ///< axis, from rest to rest; not part of the stated poses and the truth
  // Matching and output
  Matcher matcher = Matcher::census;  ///< chosen with a camera's model (camera_models.hpp)
  int window_px = 9;                  ///< edge of the matcher's window; odd
  double depth_unit_mm = 0.1;         ///< one step of the depth image
  std::uint64_t device = 1;           ///< which camera it is: its dots, its speckle and its misalignment

  static void describe(auto&& self, auto&& visit) {
    visit(self.focal_px, OptionField{"focal", "px", 50, 5000, "focal length of both infrared imagers"});
    visit(self.baseline_mm, OptionField{"baseline", "mm", 1, 1000, "distance between them"});
    visit(self.lens_blur_px, OptionField{"lens-blur", "px", 0, 5, "standard deviation of the lenses' blur"});
    visit(self.misalignment_px, OptionField{"misalignment", "px", 0, 5,
                                            "how far rows of the imagers are apart, at the image's edges"});
    visit(self.rectification_px,
          OptionField{"rectification", "px", 0, 5,
                      "standard deviation of what calibration leaves in each imager, slowly varying"});
    visit(self.supersampling, OptionField{"supersampling", "", 1, 8, "rays a pixel along each side"});
    visit(self.dots, OptionField{"dots", "", 0, 100000, "dots of the projector"});
    visit(self.dot_share,
          OptionField{"dot-share", "", 0, 1, "share of the projector's light that is in dots"});
    visit(self.bounce, OptionField{"bounce", "", 0, 10,
                                   "projector light that arrives from other surfaces, of its mean at 1 m"});
    visit(self.lamp_light, OptionField{"lamp-light", "", 0, 1000,
                                       "light of the lamp beside the imagers, at 1 m; 0: there is none"});
    visit(self.exposure,
          OptionField{"exposure", "", 0, 1e6,
                      "electrons for a white surface in the projector's mean light at 1 m; 0 sets "
                      "it by the view, as the camera does on its own"});
    visit(self.exposure_target,
          OptionField{"exposure-target", "", 0.01, 10,
                      "where that control puts the view's brighter parts, of what saturates a pixel"});
    visit(self.gain,
          OptionField{"gain", "", 1, 16, "of the imagers' signal: how many times earlier a pixel saturates"});
    visit(self.imager_difference,
          OptionField{"imager-difference", "", -0.9, 9,
                      "how much more light the right imager records; -0.1 is a tenth less"});
    visit(self.full_well_e, OptionField{"full-well", "e", 100, 1e6, "electrons at which a pixel saturates"});
    visit(self.read_noise_e, OptionField{"read-noise", "e", 0, 1000, "electrons of noise without light"});
    visit(self.speckle,
          OptionField{"speckle", "", 0, 1, "contrast of laser speckle that stays while nothing moves"});
    visit(self.speckle_turn_deg,
          OptionField{"speckle-turn", "deg", 0, 90,
                      "turn of the camera over which its speckle becomes another; 0: the least motion does"});
    visit(self.wander, OptionField{"wander", "", 0, 1, "contrast of speckle that wanders slowly"});
    visit(self.wander_frames, OptionField{"wander-frames", "", 1, 1e6, "frames over which it wanders"});
    visit(self.levels,
          OptionField{"levels", "", 0, 1, "contrast of speckle that jumps between three patterns"});
    visit(self.level_frames,
          OptionField{"level-frames", "", 1, 1e6, "frames for which a pattern persists, on average"});
    visit(self.flicker,
          OptionField{"flicker", "", 0, 0.5, "standard deviation of the exposure from frame to frame"});
    visit(self.drift_px,
          OptionField{"drift", "px", 0, 5,
                      "standard deviation of the disparity's offset between captures (temperature)"});
    visit(self.sway_mm,
          OptionField{"sway", "mm", 0, 100,
                      "standard deviation of the camera's position in a bay that gives way, along each "
                      "axis, from rest to rest; not part of the stated poses and the truth"});
    visit(self.window_px, OptionField{"window", "px", 5, 13, "edge of the matcher's window; odd"});
    visit(self.depth_unit_mm, OptionField{"depth-unit", "mm", 0.01, 10, "one step of the depth image"});
    visit(self.device, OptionField{"device", "", 0, 1e9,
                                   "which camera it is: its dots, its speckle and its misalignment"});
  }
};

}  // namespace rva
