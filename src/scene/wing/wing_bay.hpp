// A parametric wing bay: the box between two ribs and two spars.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "scene/scene.hpp"
#include "scene/wing/fittings.hpp"

namespace rva {

/// The cross-section of a stringer.
enum class StringerProfile { l, z, hat };
/// The names that scene files use.
template <>
inline constexpr auto enum_names<StringerProfile> = std::to_array<EnumName<StringerProfile>>({
    {StringerProfile::l, "l"},
    {StringerProfile::z, "z"},
    {StringerProfile::hat, "hat"},
});

/// The parameters of a bay. Its lengths are inner ones, between visible faces. Defaults are those of the
/// thesis' test section, as far as its figures show it.
struct WingBay {
  double span_m = 0.75;    ///< between the ribs' faces, along x
  double chord_m = 1.10;   ///< between the spars' faces, along y
  double height_m = 0.36;  ///< from lower to upper skin
  double skin_mm = 5.0;    ///< thickness

  /// The stiffeners that run along the span.
  struct Stringers {
    StringerProfile profile = StringerProfile::z;  ///< cross-section
    int count = 5;                                 ///< spread evenly along the chord
    double height_mm = 38.0;                       ///< above the skin
    double flange_mm = 26.0;                       ///< width of a flange
    double thickness_mm = 2.5;                     ///< of the sheet metal
  } stringers;                                     ///< on the lower skin

  /// The ribs that close the bay.
  struct Ribs {
    double thickness_mm = 3.0;        ///< of the sheet metal
    int holes = 3;                    ///< lightening holes along the chord
    double hole_diameter_mm = 150.0;  ///< of a lightening hole
  } ribs;                             ///< left and right

  /// The spars that close the bay.
  struct Spars {
    double thickness_mm = 6.0;      ///< of the web
    double flange_mm = 40.0;        ///< caps along the skins
    double rear_height_mm = 260.0;  ///< if less than the bay's height, the room behind is visible
  } spars;                          ///< near and far

  Fittings fittings;                           ///< what the bay contains besides its sheet metal
  double dirt = 0.0;                           ///< of all surfaces of the bay, 0 to 1, see Material::dirt
  bool upper_skin = false;                     ///< the thesis' section is open at the top
  double access_hole_width_mm = 460.0;         ///< elliptic, in the near spar
  double access_hole_height_mm = 260.0;        ///< likewise
  double back_wall_m = 3.0;                    ///< distance of the room's wall from the near spar; 0 for none
  std::string skin_material = "green-primer";  ///< name in the list of materials
  std::string stringer_material = "green-primer";  ///< name in the list of materials
  std::string rib_material = "green-primer";       ///< name in the list of materials
  std::string spar_material = "green-primer";      ///< name in the list of materials
};

/// The objects of the bay, in the world frame of scene.hpp: "skin-lower", "stringer-1" (nearest) ...,
/// "rib-left", "rib-right", "spar-near", "spar-far", the fittings, "floor", "back-wall".
[[nodiscard]] std::vector<SceneObject> build_wing_bay(const WingBay& bay);

/// The space between ribs, spars and skins.
[[nodiscard]] Eigen::AlignedBox3d inside_of(const WingBay& bay);

}  // namespace rva
