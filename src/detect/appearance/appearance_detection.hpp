// Findings from infrared and colour images, for changes that depth does not show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detect/spatial/judged_change.hpp"
#include "detect/spatial/spatial_detection.hpp"

namespace rva {

/// Share of the allowed false findings that is assigned to depth if other images are compared, too.
inline constexpr double share_of_depth = 0.5;

/// Images other than depth that both sides have.
struct ComparedImages {
  std::vector<Light> lights;  ///< in which there are infrared images
  bool color = false;         ///< colour images are lit (have_lit_color())

  [[nodiscard]] bool any() const { return color || !lights.empty(); }
};

/// Selects the images to compare. Under the projector, a comparison needs four captures a side, since fewer
/// leave too many pixels covered by dots; under a lamp, and for colour images, two.
/// @param warnings receives the reason if infrared images that some captures have are not compared
[[nodiscard]] ComparedImages comparable_images(const Captures& initial, const Captures& final,
                                               std::vector<std::string>& warnings);

/// Compares the infrared images of both sides in each light (appearance_evidence.hpp) and their colour images
/// (color_evidence.hpp), if the camera returned nearly to its initial pose. Findings of depth that coincide
/// with a change of appearance are marked with that evidence. Findings of depth without it are dropped where
/// infrared images were compared and depth alone is not certain enough. Changes of appearance elsewhere
/// become findings of kind `appearance`, after all others.
/// @param images          as returned by comparable_images()
/// @param false_findings  allowed for appearance alone, in all lights together
/// @throws Error when an image cannot be read; Interrupted
void add_appearance(const Captures& initial, const Captures& final, const ComparedImages& images,
                    const PlacedCaptures& placed, double false_findings, const RegionOptions& regions,
                    Detection& detection);

/// Selects the images to compare for a camera that stood still: one capture a side is enough, and the right
/// imager is not needed. No images are selected if the depth camera has lens distortion.
/// @param initial, final one capture each
[[nodiscard]] ComparedImages still_images(const Captures& initial, const Captures& final);

/// Changes that images other than depth show.
struct ImageChanges {
  std::vector<JudgedChange> infrared;  ///< one for each light
  std::optional<JudgedChange> color;

  [[nodiscard]] bool any() const { return color || !infrared.empty(); }
};

/// Compares two captures of a camera that stood still, pixel by pixel, including the projector's
/// dots (still_evidence.hpp).
/// @param images   as returned by still_images()
/// @param warnings receives the reason if images could not be compared
/// @throws Error when an infrared image cannot be read; Interrupted
[[nodiscard]] ImageChanges still_changes(const Capture& initial, const Capture& final,
                                         const ComparedImages& images, const DepthView& final_view,
                                         std::vector<std::string>& warnings);

/// Adds the changes found by still_changes() to a detection, in the way of add_appearance().
void add_still_appearance(ImageChanges changes, const DepthView& final_view, double false_findings,
                          const RegionOptions& regions, Detection& detection);

}  // namespace rva
