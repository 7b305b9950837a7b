#include "scene/material.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace rva {
namespace {

// Diffuse reflectances at 850 nm are plausible, not measured. They follow the near-infrared ends of published
// reflectance spectra (ECOSTRESS and USGS spectral libraries for paints, concrete, plaster, paper, cloth and
// leather), which differ from visible reflectances in three ways. Dyes transmit infrared, so dyed cloth,
// leather and plastics are nearly as bright as white ones; carbon black absorbs it, so rubber and black
// plastics are dark; dyed black anodising lies in between. Polished metal hardly scatters light and is
// visible only by its highlights.
//
// Grain is the texture that a stereo camera matches in the absence of projected dots: the orange peel and
// speckle of paint, the weave of cloth, the sand of concrete.
constexpr std::array<Material, 28> materials{{
    {"green-primer", 0.50, 0.02, 6, 0.05, 0.0015, {132, 141, 72}},
    {"white-paint", 0.60, 0.04, 25, 0.03, 0.0020, {225, 225, 220}},
    {"matt-grey", 0.42, 0.01, 5, 0.06, 0.0015, {128, 128, 128}},
    {"anodised-aluminium", 0.38, 0.18, 30, 0.03, 0.0010, {168, 170, 174}},
    {"anodised-gold", 0.45, 0.18, 30, 0.03, 0.0010, {190, 150, 60}},
    {"bare-aluminium", 0.18, 0.55, 90, 0.02, 0.0010, {150, 152, 156}},
    {"steel", 0.16, 0.45, 110, 0.02, 0.0010, {120, 122, 126}},
    {"brass", 0.22, 0.45, 80, 0.02, 0.0010, {170, 140, 70}},
    {"black-anodised", 0.15, 0.10, 30, 0.03, 0.0010, {28, 28, 30}},
    {"black-rubber", 0.04, 0.02, 8, 0.10, 0.0010, {22, 22, 22}},
    {"black-plastic", 0.05, 0.05, 40, 0.04, 0.0010, {20, 20, 22}},
    {"red-plastic", 0.55, 0.05, 60, 0.02, 0.0010, {190, 30, 30}},
    {"yellow-plastic", 0.60, 0.05, 60, 0.02, 0.0010, {225, 185, 30}},
    {"blue-plastic", 0.45, 0.05, 60, 0.02, 0.0010, {30, 60, 170}},
    {"white-plastic", 0.65, 0.05, 60, 0.02, 0.0010, {230, 230, 228}},
    {"fabric-white", 0.65, 0.00, 1, 0.15, 0.0012, {220, 218, 212}},
    {"fabric-red", 0.60, 0.00, 1, 0.15, 0.0012, {165, 35, 40}},
    {"fabric-grey", 0.50, 0.00, 1, 0.15, 0.0012, {130, 130, 132}},
    {"leather", 0.50, 0.03, 10, 0.12, 0.0020, {170, 125, 80}},
    {"paper", 0.75, 0.01, 5, 0.03, 0.0010, {235, 233, 225}},
    {"masking-tape", 0.62, 0.02, 8, 0.06, 0.0010, {215, 195, 140}},
    {"concrete", 0.38, 0.00, 1, 0.20, 0.0040, {140, 138, 132}},
    {"plaster", 0.72, 0.00, 1, 0.06, 0.0030, {222, 220, 212}},
    {"wood", 0.60, 0.01, 6, 0.18, 0.0030, {175, 135, 90}},
    {"carbon-fibre", 0.07, 0.12, 40, 0.12, 0.0020, {40, 40, 42}},
    {"yellow-primer", 0.58, 0.02, 6, 0.05, 0.0015, {196, 176, 60}},
    {"wax-coating", 0.34, 0.10, 20, 0.08, 0.0040, {120, 92, 50}},
    {"sealant", 0.36, 0.03, 12, 0.06, 0.0020, {128, 116, 96}},
}};

}  // namespace

const Material& find_material(std::string_view name) {
  const Material* material = find_material_or_null(name);
  if (material == nullptr) throw std::out_of_range("no material " + std::string(name));
  return *material;
}

const Material* find_material_or_null(std::string_view name) {
  const auto* const found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return found == materials.end() ? nullptr : found;
}

std::vector<std::string_view> material_names() {
  std::vector<std::string_view> names;
  for (const Material& material : materials) names.push_back(material.name);
  return names;
}

}  // namespace rva
