#include "scene/wing/stringers.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "scene/solids/shapes.hpp"
#include "scene/wing/rivets.hpp"

namespace rva {
namespace {

// Inclination of a hat's webs: horizontal offset per height.
constexpr double hat_slant = 0.35;

using Outline = std::array<Eigen::Vector2d, 4>;

// The cross-section of a stringer, in y and z.
struct Section {
  std::vector<Outline> pieces;  // counterclockwise seen from +x
  std::vector<double> rivet_rows_y_m;
};

struct Form {
  double height_m;
  double flange_m;
  double sheet_m;
  explicit Form(const WingBay::Stringers& form)
      : height_m(form.height_mm * 1e-3), flange_m(form.flange_mm * 1e-3), sheet_m(form.thickness_mm * 1e-3) {}
};

Outline rectangle(double low_y, double low_z, double high_y, double high_z) {
  return {Eigen::Vector2d(low_y, low_z), Eigen::Vector2d(high_y, low_z), Eigen::Vector2d(high_y, high_z),
          Eigen::Vector2d(low_y, high_z)};
}

// The foot points towards the access hole (-y), so that its rivets are visible.
Section l_section(const Form& form) {
  const double half = form.sheet_m / 2;
  return {{rectangle(-half, 0, half, form.height_m), rectangle(half - form.flange_m, 0, half, form.sheet_m)},
          {-form.flange_m / 2}};
}

Section z_section(const Form& form) {
  Section section = l_section(form);
  const double half = form.sheet_m / 2;
  section.pieces.push_back(
      rectangle(-half, form.height_m - form.sheet_m, form.flange_m - half, form.height_m));
  return section;
}

Section hat_section(const Form& form) {
  const double crown = form.flange_m / 2;
  const double root = crown + hat_slant * form.height_m;
  const double sheet = form.sheet_m;
  const double tip = root + form.flange_m;
  return {{rectangle(-crown, form.height_m - sheet, crown, form.height_m),
           {Eigen::Vector2d(root - sheet, 0), Eigen::Vector2d(root, 0), Eigen::Vector2d(crown, form.height_m),
            Eigen::Vector2d(crown - sheet, form.height_m)},
           {Eigen::Vector2d(-root, 0), Eigen::Vector2d(sheet - root, 0),
            Eigen::Vector2d(sheet - crown, form.height_m), Eigen::Vector2d(-crown, form.height_m)},
           rectangle(root - sheet, 0, tip, sheet),
           rectangle(-tip, 0, sheet - root, sheet)},
          {-(root + tip) / 2, (root + tip) / 2}};
}

Section section_of(const WingBay::Stringers& stringers) {
  const Form form(stringers);
  switch (stringers.profile) {
    case StringerProfile::l:
      return l_section(form);
    case StringerProfile::z:
      return z_section(form);
    case StringerProfile::hat:
      break;
  }
  return hat_section(form);
}

}  // namespace

TriangleMesh stringer(const WingBay::Stringers& form, double length_m) {
  Transform along_x = Transform::Identity();
  along_x.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // the outline's x and y become y and z
  along_x.translation().x() = -length_m / 2;

  const Section section = section_of(form);
  TriangleMesh mesh;
  for (const Outline& piece : section.pieces) mesh.append(transformed(prism(piece, length_m), along_x));
  const double sheet_m = form.thickness_mm * 1e-3;
  for (const double y_m : section.rivet_rows_y_m)
    mesh.append(rivet_row({-length_m / 2, y_m, sheet_m}, {length_m / 2, y_m, sheet_m}));
  return mesh;
}

double stringer_width_m(const WingBay::Stringers& form) {
  Eigen::AlignedBox2d extent;
  for (const Outline& piece : section_of(form).pieces) {
    for (const Eigen::Vector2d& corner : piece) extent.extend(corner);
  }
  return extent.sizes().x();
}

}  // namespace rva
