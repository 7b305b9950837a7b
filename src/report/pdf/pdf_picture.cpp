#include "report/pdf/pdf_picture.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>

namespace rva::pdf {
namespace {

constexpr double gap_pt = 2.0 * pt_per_mm;

// The file is put into the document as it is; the surface gives its size alone.
std::shared_ptr<cairo_surface_t> surface_of(const JpegPicture& picture) {
  std::shared_ptr<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width_px, picture.height_px),
      cairo_surface_destroy);
  auto* const copy = new std::vector<std::byte>(picture.jpeg);
  cairo_surface_set_mime_data(
      surface.get(), CAIRO_MIME_TYPE_JPEG, reinterpret_cast<const unsigned char*>(copy->data()), copy->size(),
      [](void* unused) { delete static_cast<std::vector<std::byte>*>(unused); }, copy);
  return surface;
}

void paint(cairo_t* cairo, cairo_surface_t* surface, double left_pt, double top_pt, double scale) {
  cairo_save(cairo);
  cairo_translate(cairo, left_pt, top_pt);
  cairo_scale(cairo, scale, scale);
  cairo_set_source_surface(cairo, surface, 0.0, 0.0);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

}  // namespace

Box picture_box(const JpegPicture& picture, double width_pt) {
  constexpr double most_high_pt = 150.0 * pt_per_mm;
  const double scale = std::min(width_pt / picture.width_px, most_high_pt / picture.height_px);
  const double height_pt = scale * picture.height_px;
  Box box;
  box.height_pt = height_pt;
  box.marks.push_back(
      {.y_pt = 0.0,
       .height_pt = height_pt,
       .draw = [surface = surface_of(picture), scale](cairo_t* cairo, double left_pt, double top_pt) {
         paint(cairo, surface.get(), left_pt, top_pt, scale);
       }});
  return box;
}

std::vector<Box> figure_rows(const Content& figures, int columns, const Setting& setting) {
  Setting column = setting;
  column.width_pt = (setting.width_pt - gap_pt * (columns - 1)) / columns;
  std::vector<Box> rows;
  int next = 0;
  for (const ReportPart& figure : figures.parts()) {
    if (next == 0) {
      rows.emplace_back();
      rows.back().above_pt = gap_pt;
    }
    Box box = stacked(boxes_of(figure.inside, column));
    shift(box, next * (column.width_pt + gap_pt), 0.0);
    rows.back().height_pt = std::max(rows.back().height_pt, box.height_pt);
    std::ranges::move(box.marks, std::back_inserter(rows.back().marks));
    next = (next + 1) % columns;
  }
  return rows;
}

}  // namespace rva::pdf
