// The reflection of infrared and visible light by materials.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// Reflection is diffuse (Lambert) plus a glossy lobe (normalised Blinn-Phong), whose highlights depend on
/// the position of the eye. Grain varies the diffuse part over the surface, and dirt darkens it in patches.
struct Material {
  std::string_view name;   ///< name in scene files
  double infrared_albedo;  ///< diffuse reflectance at 850 nm, 0 to 1
  double specular;         ///< share of light in the glossy lobe, 0 to 1
  int gloss;               ///< exponent of the lobe: 5 is satin, 200 a mirror-like polish
  double grain;            ///< relative contrast of the surface's own texture, 0 to 1
  double grain_m;          ///< size of that texture, metres
  Rgb color;               ///< diffuse, in visible light
  double dirt = 0.0;       ///< share of light that dust and old oil take where they are thickest, 0 to 1
};

/// The material of this name. @throws std::out_of_range for a name that material_names() does not list
[[nodiscard]] const Material& find_material(std::string_view name);

/// Null for an unknown name.
[[nodiscard]] const Material* find_material_or_null(std::string_view name);

/// The names of all materials.
[[nodiscard]] std::vector<std::string_view> material_names();

}  // namespace rva
