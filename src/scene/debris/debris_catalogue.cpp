#include "scene/debris/debris_catalogue.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scene/debris/debris_shapes.hpp"

namespace rva {
namespace {

struct Recipe {
  DebrisKind kind;
  Parts (*make)(Random&);
};

template <Parts (*make)()>
Parts always(Random&) {
  return make();
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {{"flashlight", 150.0, "two-cell aluminium torch: 30 mm body, 38 mm head"}, always<flashlight>},
      {{"flashlight-small", 92.0, "one-cell (AA) aluminium torch: 14 mm body, 18 mm head"},
       always<small_flashlight>},
      {{"screwdriver", 210.0, "ISO 8764 PH2 blade of 100 mm, workshop handle of 32 mm"}, always<screwdriver>},
      {{"wrench", 160.0, "DIN 3113 combination wrench, 13 mm jaw"}, always<wrench>},
      {{"socket", 38.0, "DIN 3124 socket, 17 mm, 1/2 in. drive"}, always<socket>},
      {{"drill-bit-3.3", 65.0, "DIN 338 twist drill, 3.3 mm"},
       [](Random&) { return drill_bit(3.3, 65, 36); }},
      {{"drill-bit-6", 93.0, "DIN 338 twist drill, 6 mm"}, [](Random&) { return drill_bit(6.0, 93, 57); }},
      {{"clip", 57.0, "Cleco K-series sheet holder, 3/16 in."}, always<sheet_holder>},
      {{"pen", 149.0, "ball-point pen with a hexagonal barrel of 8.2 mm, cap on"}, always<pen>},
      {{"key", 57.0, "house key, 57 x 25 x 2.2 mm"}, always<key>},
      {{"collar-0.27", 0.27 * 25.4, "thesis, figure 3.10: 0.27 in."},
       [](Random&) { return swaged_collar(0.27); }},
      {{"collar-0.36", 0.36 * 25.4, "thesis, figure 3.10: 0.36 in."},
       [](Random&) { return swaged_collar(0.36); }},
      {{"collar-0.44", 0.44 * 25.4, "thesis, figure 3.10: 0.44 in."},
       [](Random&) { return swaged_collar(0.44); }},
      {{"collar-0.53", 0.53 * 25.4, "thesis, figure 3.10: 0.53 in."},
       [](Random&) { return swaged_collar(0.53); }},
      {{"bolt-m6", 34.0, "ISO 4014 M6 x 30: head 10 mm across flats, 4 mm high"}, always<bolt_m6>},
      {{"bolt-hi-lok", 18.0, "HL18-type shear pin, 3/16 in., flat head of 7.6 mm"}, always<hi_lok>},
      {{"nut-m6", 11.547, "ISO 4032 M6: 10 mm across flats, 5.2 mm high"}, always<nut_m6>},
      {{"nut-plate", 25.0, "MS21047-type anchor nut, No. 10: rivets 17.5 mm apart"}, always<nut_plate>},
      {{"rivet", 11.2, "MS20470 universal head, 5/32 x 3/8 in."}, always<rivet>},
      {{"washer-m6", 12.0, "ISO 7089 M6: 6.4 x 12 x 1.6 mm"}, always<washer_m6>},
      {{"swarf", 25.0, "coiled aluminium chip of a hand drill, 1.8 mm wide"}, swarf},
      {{"wire", 80.0, "cut-off insulated wire of about 1.8 mm"}, wire},
      {{"tape-roll", 95.0, "masking tape, 25 mm wide on a 76 mm (3 in.) core, part used"}, always<tape_roll>},
      {{"tape", 50.0, "curled strip of masking tape, 19 mm wide"}, tape_strip},
      {{"rag", 200.0, "workshop cloth, about 200 x 150 mm, crumpled"}, rag},
      {{"glove", 225.0, "leather work glove, size 9 (EN ISO 21420)"}, glove},
  };
  return all;
}

const std::vector<Recipe>& unlisted_recipes() {
  static const std::vector<Recipe> all{
      {{"spray-can", 188.0, "aerosol can of 400 ml, 65 mm"}, always<spray_can>},
      {{"tape-measure", 73.5, "pocket tape of 5 m"}, always<tape_measure>},
      {{"pliers", 165.7, "ISO 5746 combination pliers, 165 mm"}, always<pliers>},
      {{"battery", 60.0, "IEC 60086 R20 (D): 33 x 60 mm"}, always<battery>},
      {{"paper-cup", 94.0, "paper cup of 200 ml"}, always<paper_cup>},
      {{"hex-key", 97.0, "ISO 2936 hexagon key, 6 mm"}, always<hex_key>},
      {{"mirror", 212.5, "inspection mirror, 41 mm, with a rod"}, always<mirror>},
      {{"paint-brush", 190.5, "flat brush, 40 mm"}, always<paint_brush>},
      {{"hose-clamp", 52.5, "DIN 3017 worm-drive clamp for 40 mm, 12 mm wide"}, always<hose_clamp>},
      {{"protective-cap", 25.0, "plastic cap of a hydraulic fitting"}, always<protective_cap>},
      {{"random-shape", 200.0, "none: boxes, cylinders, tubes and cones by chance"}, random_shape},
  };
  return all;
}

const Recipe* find_recipe(const std::vector<Recipe>& recipes, std::string_view name) {
  const auto found =
      std::ranges::find_if(recipes, [&](const Recipe& recipe) { return recipe.kind.name == name; });
  return found == recipes.end() ? nullptr : &*found;
}

std::vector<DebrisKind> kinds_of(const std::vector<Recipe>& recipes) {
  std::vector<DebrisKind> kinds;
  for (const Recipe& recipe : recipes) kinds.push_back(recipe.kind);
  return kinds;
}

/// Centre of volume, from the tetrahedra between the triangles and the origin.
Eigen::Vector3d center_of(const Parts& parts) {
  Eigen::Vector3d moment(0, 0, 0);
  double six_volumes = 0.0;
  for (const Part& part : parts) {
    for (const auto& [i, j, k] : part.mesh.triangles) {
      const Eigen::Vector3d a = part.mesh.vertices[i].cast<double>();
      const Eigen::Vector3d b = part.mesh.vertices[j].cast<double>();
      const Eigen::Vector3d c = part.mesh.vertices[k].cast<double>();
      const double six_volume = a.dot(b.cross(c));
      moment += six_volume * (a + b + c) / 4.0;
      six_volumes += six_volume;
    }
  }
  return moment / six_volumes;
}

}  // namespace

const std::vector<DebrisKind>& debris_catalogue() {
  static const std::vector<DebrisKind> kinds = kinds_of(recipes());
  return kinds;
}

const std::vector<DebrisKind>& unlisted_kinds() {
  static const std::vector<DebrisKind> kinds = kinds_of(unlisted_recipes());
  return kinds;
}

const DebrisKind* find_debris_kind(std::string_view name) {
  const Recipe* recipe = find_recipe(recipes(), name);
  return recipe == nullptr ? nullptr : &recipe->kind;
}

std::vector<Part> make_debris(std::string_view kind, std::uint64_t shape_seed) {
  const Recipe* recipe = find_recipe(recipes(), kind);
  if (recipe == nullptr) recipe = find_recipe(unlisted_recipes(), kind);
  if (recipe == nullptr) throw std::out_of_range("no debris of kind " + std::string(kind));
  Random random(shape_seed);
  Parts parts = recipe->make(random);
  const Eigen::Vector3d center = center_of(parts);
  for (Part& part : parts) {
    part.mesh = scaled(moved(part.mesh, -center), Eigen::Vector3d::Constant(1e-3));
  }
  return parts;
}

}  // namespace rva
