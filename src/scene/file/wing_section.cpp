#include "scene/file/wing_section.hpp"

#include <fmt/format.h>

#include "scene/file/object_fields.hpp"
#include "scene/wing/stringers.hpp"

namespace rva {
namespace {

// Minimum width of sheet between a hole and the edge.
constexpr double least_margin_mm = 2.0;
constexpr NumberRange sheet_mm{0.5, 50.0};
constexpr NumberRange profile_mm{2.0, 500.0};
constexpr NumberRange hole_mm{0.0, 5000.0};

void read_name_of_material(const YamlNode& group, std::string& material) {
  if (group.has("material")) material = read_material(group).name;
}

void read_skin(const YamlNode& group, WingBay& bay) {
  group.allow_only({"thickness_mm", "upper", "material"});
  group.read("thickness_mm", bay.skin_mm, sheet_mm);
  group.read("upper", bay.upper_skin);
  read_name_of_material(group, bay.skin_material);
}

void check_stringers(const YamlNode& group, const WingBay& bay) {
  const WingBay::Stringers& form = bay.stringers;
  if (form.thickness_mm > form.height_mm / 3 || form.thickness_mm > form.flange_mm / 3)
    throw group.error("stringers' sheet is too thick for their height or flange",
                      "make thickness_mm a third of either or less");
  if (form.height_mm * 1e-3 >= bay.height_m)
    throw group.error("stringers are as high as the bay",
                      "make height_mm smaller or the wing's height_m larger");
  const double pitch_m = bay.chord_m / (form.count + 1);
  if (form.count > 0 && stringer_width_m(form) >= pitch_m)
    throw group.error(fmt::format("stringers {:.0f} mm wide do not fit {:.0f} mm apart",
                                  stringer_width_m(form) * 1e3, pitch_m * 1e3),
                      "use fewer or smaller ones");
}

void read_stringers(const YamlNode& group, WingBay& bay) {
  group.allow_only({"profile", "count", "height_mm", "flange_mm", "thickness_mm", "material"});
  if (const auto profile = group.find("profile")) {
    const std::size_t chosen = profile->choice("profile", names_of<StringerProfile>());
    bay.stringers.profile = enum_names<StringerProfile>.at(chosen).value;
  }
  group.read("count", bay.stringers.count, 0, 100);
  group.read("height_mm", bay.stringers.height_mm, profile_mm);
  group.read("flange_mm", bay.stringers.flange_mm, profile_mm);
  group.read("thickness_mm", bay.stringers.thickness_mm, sheet_mm);
  read_name_of_material(group, bay.stringer_material);
}

void read_ribs(const YamlNode& group, WingBay& bay) {
  group.allow_only({"thickness_mm", "holes", "hole_diameter_mm", "material"});
  group.read("thickness_mm", bay.ribs.thickness_mm, sheet_mm);
  group.read("holes", bay.ribs.holes, 0, 20);
  group.read("hole_diameter_mm", bay.ribs.hole_diameter_mm, {1.0, hole_mm.high});
  read_name_of_material(group, bay.rib_material);
}

void check_ribs(const YamlNode& group, const WingBay& bay) {
  if (bay.ribs.holes == 0) return;
  const double room_mm = bay.ribs.hole_diameter_mm + 2 * least_margin_mm;
  if (room_mm > bay.height_m * 1e3 || room_mm > bay.chord_m * 1e3 / bay.ribs.holes)
    throw group.error("lightening holes do not fit into the ribs", "use fewer or smaller ones");
}

void read_spars(const YamlNode& group, WingBay& bay) {
  group.allow_only({"thickness_mm", "flange_mm", "rear_height_mm", "material"});
  group.read("thickness_mm", bay.spars.thickness_mm, sheet_mm);
  group.read("flange_mm", bay.spars.flange_mm, profile_mm);
  group.read("rear_height_mm", bay.spars.rear_height_mm, {10.0, 3000.0});
  read_name_of_material(group, bay.spar_material);
}

void check_spars(const YamlNode& group, const WingBay& bay) {
  if (bay.spars.rear_height_mm > bay.height_m * 1e3)
    throw group.error("the rear spar is higher than the bay", "make rear_height_mm smaller");
  if (bay.spars.rear_height_mm < 3 * bay.spars.thickness_mm)
    throw group.error("the rear spar is too low for its two caps", "make rear_height_mm larger");
  if (bay.spars.flange_mm * 1e-3 >= bay.chord_m / 3)
    throw group.error("the spars' caps fill the bay", "make flange_mm smaller");
}

void read_access_hole(const YamlNode& group, WingBay& bay) {
  group.allow_only({"width_mm", "height_mm"});
  group.read("width_mm", bay.access_hole_width_mm, hole_mm);
  group.read("height_mm", bay.access_hole_height_mm, hole_mm);
}

void check_access_hole(const YamlNode& group, const WingBay& bay) {
  const double height_mm = bay.height_m * 1e3 - 2 * least_margin_mm;
  const double width_mm = bay.span_m * 1e3 - 2 * least_margin_mm;
  if (bay.access_hole_width_mm > width_mm || bay.access_hole_height_mm > height_mm)
    throw group.error("the access hole does not fit into the near spar", "make it smaller");
}

// Maximum number of fittings of one kind.
constexpr int most_fittings = 100;

void read_counts(const YamlNode& group, Fittings& fittings) {
  group.read("brackets", fittings.brackets, 0, most_fittings);
  group.read("hoses", fittings.hoses, 0, most_fittings);
  group.read("cables", fittings.cables, 0, most_fittings);
  group.read("sealant", fittings.sealant, 0, most_fittings);
  group.read("collars", fittings.collars, 0, most_fittings);
  if (const auto seed = group.find("seed")) fittings.seed = seed->seed();
}

void read_fittings(const YamlNode& group, WingBay& bay) {
  group.allow_only({"brackets", "hoses", "cables", "sealant", "collars", "seed"});
  read_counts(group, bay.fittings);
}

using Group = void (*)(const YamlNode&, WingBay&);
using Check = void (*)(const YamlNode&, const WingBay&);

void read_group(const YamlNode& wing, const char* key, Group group, WingBay& bay) {
  if (const auto found = wing.find(key)) group(*found, bay);
}

// The bay's size may conflict with the defaults of a group that the file omits; the error then
// names the wing.
void check_group(const YamlNode& wing, const char* key, Check check, const WingBay& bay) {
  check(wing.has(key) ? wing.at(key) : wing, bay);
}

}  // namespace

WingBay read_wing(const YamlNode& section) {
  section.allow_only({"span_m", "chord_m", "height_m", "back_wall_m", "skin", "stringers", "ribs", "spars",
                      "access_hole", "fittings", "dirt"});
  WingBay bay;
  section.read("span_m", bay.span_m, {0.1, 20.0});
  section.read("chord_m", bay.chord_m, {0.1, 20.0});
  section.read("height_m", bay.height_m, {0.05, 3.0});
  section.read("back_wall_m", bay.back_wall_m, {0.0, 100.0});
  read_group(section, "skin", read_skin, bay);
  read_group(section, "stringers", read_stringers, bay);
  read_group(section, "ribs", read_ribs, bay);
  read_group(section, "spars", read_spars, bay);
  read_group(section, "access_hole", read_access_hole, bay);
  read_group(section, "fittings", read_fittings, bay);
  section.read("dirt", bay.dirt, {0.0, 1.0});

  check_group(section, "stringers", check_stringers, bay);
  check_group(section, "ribs", check_ribs, bay);
  check_group(section, "spars", check_spars, bay);
  check_group(section, "access_hole", check_access_hole, bay);
  if (bay.back_wall_m > 0 && bay.back_wall_m < bay.chord_m + 0.1)
    throw section.error("the back wall stands inside the wing",
                        "make back_wall_m larger than chord_m + 0.1, or 0 for none");
  return bay;
}

TraceCounts read_traces(const YamlNode& section) {
  constexpr int most_traces = 50;
  section.allow_only({"dust", "smears", "fingerprints", "seed"});
  TraceCounts counts;
  section.read("dust", counts.dust, 0, most_traces);
  section.read("smears", counts.smears, 0, most_traces);
  section.read("fingerprints", counts.fingerprints, 0, most_traces);
  if (const auto seed = section.find("seed")) counts.seed = seed->seed();
  return counts;
}

Work read_work(const YamlNode& section) {
  section.allow_only(
      {"brackets", "hoses", "cables", "sealant", "collars", "seed", "rehung", "parts", "traces"});
  Work work;
  read_counts(section, work.installed);
  section.read("rehung", work.rehung, 0, most_fittings);
  if (const auto traces = section.find("traces")) work.traces = read_traces(*traces);
  return work;
}

}  // namespace rva
