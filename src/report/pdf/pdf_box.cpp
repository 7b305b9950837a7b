#include "report/pdf/pdf_box.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace rva::pdf {
namespace {

void fill(cairo_t* cairo, const Ink& ink, double x_pt, double y_pt, double width_pt, double height_pt) {
  cairo_set_source_rgb(cairo, ink.red, ink.green, ink.blue);
  cairo_rectangle(cairo, x_pt, y_pt, width_pt, height_pt);
  cairo_fill(cairo);
}

void draw_border(const Border& border, cairo_t* cairo, double left_pt, double top_pt, double height_pt) {
  const double width_pt = border.width_pt;
  fill(cairo, border.ink, left_pt, top_pt, border.left_pt, height_pt);
  if (border.around_pt <= 0.0) return;
  fill(cairo, border.ink, left_pt, top_pt, width_pt, border.around_pt);
  fill(cairo, border.ink, left_pt, top_pt + height_pt - border.around_pt, width_pt, border.around_pt);
  fill(cairo, border.ink, left_pt + width_pt - border.around_pt, top_pt, border.around_pt, height_pt);
}

double bottom_of(const Mark& mark) { return mark.y_pt + mark.height_pt; }

// The lowest end of a page on which no mark is cut: marks that reach beyond it move on, and with them all
// that begin below these do.
double page_end(const Box& box, double room_pt) {
  double end_pt = room_pt;
  for (bool moved = true; moved;) {
    moved = false;
    for (const Mark& mark : box.marks)
      if (mark.y_pt < end_pt && bottom_of(mark) > end_pt) {
        end_pt = mark.y_pt;
        moved = true;
      }
  }
  return end_pt;
}

}  // namespace

Box stacked(const std::vector<Box>& boxes) {
  Box all;
  for (Box box : boxes) {
    const double y_pt = all.height_pt + (all.height_pt > 0.0 ? box.above_pt : 0.0);
    shift(box, 0.0, y_pt);
    all.height_pt = y_pt + box.height_pt;
    std::ranges::move(box.marks, std::back_inserter(all.marks));
  }
  return all;
}

void shift(Box& box, double right_pt, double down_pt) {
  for (Mark& mark : box.marks) {
    mark.y_pt += down_pt;
    if (right_pt != 0.0)
      mark.draw = [draw = std::move(mark.draw), right_pt](cairo_t* cairo, double left_pt, double top_pt) {
        draw(cairo, left_pt + right_pt, top_pt);
      };
  }
}

std::pair<Box, Box> divided(const Box& box, double room_pt) {
  if (box.height_pt <= room_pt) return {box, {}};
  Box part = box;
  Box rest = box;
  const double end_pt = page_end(box, room_pt);
  std::erase_if(part.marks, [&](const Mark& mark) { return bottom_of(mark) > end_pt; });
  std::erase_if(rest.marks, [&](const Mark& mark) { return bottom_of(mark) <= end_pt; });
  part.height_pt = 0.0;
  for (const Mark& mark : part.marks) part.height_pt = std::max(part.height_pt, bottom_of(mark));
  double first_pt = std::numeric_limits<double>::infinity();
  for (const Mark& mark : rest.marks) first_pt = std::min(first_pt, mark.y_pt);
  if (rest.marks.empty()) first_pt = rest.height_pt;
  shift(rest, 0.0, -first_pt);
  rest.height_pt -= first_pt;
  return {part, rest};
}

Mark rule(const Ink& ink, double y_pt, double width_pt, double thickness_pt) {
  return {
      .y_pt = y_pt, .height_pt = thickness_pt, .draw = [=](cairo_t* cairo, double left_pt, double top_pt) {
        fill(cairo, ink, left_pt, top_pt, width_pt, thickness_pt);
      }};
}

void draw(const Box& box, cairo_t* cairo, double left_pt, double top_pt) {
  if (box.border.width_pt > 0.0) draw_border(box.border, cairo, left_pt, top_pt, box.height_pt);
  for (const Mark& mark : box.marks) mark.draw(cairo, left_pt, top_pt + mark.y_pt);
}

}  // namespace rva::pdf
