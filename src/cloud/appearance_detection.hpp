// Findings from infrared and colour images: what depth shows nothing of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/judged_change.hpp"
#include "cloud/spatial_detection.hpp"

namespace rva {

/// The share of the false findings allowed that is left to depth where other images are compared, too.
inline constexpr double share_of_depth = 0.5;

/// Which images both sides have, besides depth.
struct ComparedImages {
  std::vector<Light> lights;  ///< of infrared images
  bool color = false;         ///< there is light in the colour images (have_lit_color())

  [[nodiscard]] bool any() const { return color || !lights.empty(); }
};

/// Under the projector, a comparison takes four captures a side, since fewer leave too many places under
/// dots; under a lamp, and of colour images, two.
/// @param warnings gets why infrared images are not compared, where some captures have them
[[nodiscard]] ComparedImages comparable_images(const Captures& initial, const Captures& final,
                                               std::vector<std::string>& warnings);

/// Compares the sides' infrared images in each light (appearance_evidence.hpp) and their colour images
/// (color_evidence.hpp), where the camera came back nearly to where it was. Findings of depth get the
/// evidence of what looks different there; those without are dropped where infrared images were compared and
/// depth alone is not certain enough. What looks different elsewhere becomes findings of kind `appearance`,
/// after all others.
/// @param images          as of comparable_images()
/// @param false_findings  allowed for appearance alone, of all lights together
/// @throws Error when an image cannot be read; Interrupted
void add_appearance(const Captures& initial, const Captures& final, const ComparedImages& images,
                    const PlacedCaptures& placed, double false_findings, const RegionOptions& regions,
                    Detection& detection);

/// The same for a camera that stood still: one capture a side is enough, and the right imager's image is not
/// needed. There are none where the lens bends rays.
/// @param initial, final one capture each
[[nodiscard]] ComparedImages still_images(const Captures& initial, const Captures& final);

/// What images of both sides show of change.
struct ImageChanges {
  std::vector<JudgedChange> infrared;  ///< one of each light
  std::optional<JudgedChange> color;

  [[nodiscard]] bool any() const { return color || !infrared.empty(); }
};

/// Compares the images of a camera that stood still between two captures pixel by pixel, dots included
/// (still_evidence.hpp).
/// @param images   as of still_images()
/// @param warnings gets why images could not be compared
/// @throws Error when an infrared image cannot be read; Interrupted
[[nodiscard]] ImageChanges still_changes(const Capture& initial, const Capture& final,
                                         const ComparedImages& images, const DepthView& final_view,
                                         std::vector<std::string>& warnings);

/// Findings of still_changes(), as add_appearance() has them.
void add_still_appearance(ImageChanges changes, const DepthView& final_view, double false_findings,
                          const RegionOptions& regions, Detection& detection);

}  // namespace rva
