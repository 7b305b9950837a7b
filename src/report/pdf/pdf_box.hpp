// What pages are made of: boxes that are stacked, and divided only where nothing is cut.
#pragma once

#include <pango/pangocairo.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace rva::pdf {

/// A colour, each component from 0 to 1.
struct Ink {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

/// Something that is drawn whole: a line of text, a picture, a rule. Lengths are points, y is downwards.
struct Mark {
  double y_pt = 0.0;       ///< its upper end, from that of its box
  double height_pt = 0.0;  ///< what no page break may cut
  /// Draws it. @param left_pt, top_pt the box's left edge and the mark's upper end on the page
  std::function<void(cairo_t*, double left_pt, double top_pt)> draw{};
};

/// A rule along the left side of a box, or around it, on each page that the box is on.
struct Border {
  Ink ink{};
  double left_pt = 0.0;    ///< width of the rule at the left
  double around_pt = 0.0;  ///< width of the other three; 0 for none
  double width_pt = 0.0;   ///< of the box
};

/// Marks that stay together where a page has room for them.
struct Box {
  std::vector<Mark> marks{};
  double height_pt = 0.0;
  double above_pt = 0.0;         ///< distance to the box before it; none at the top of a page
  bool keeps_with_next = false;  ///< a heading, which is nothing without what follows
  Border border{};
  std::shared_ptr<const Box> head{};  ///< of a table, drawn again where the box begins a page
};

/// Boxes as one that is not divided; the distances between them are kept.
[[nodiscard]] Box stacked(const std::vector<Box>& boxes);

/// Moves marks to the right and down.
void shift(Box& box, double right_pt, double down_pt);

/// The part of a box that fits, and the rest, which begins with a mark. The part is empty where not even the
/// first mark fits.
[[nodiscard]] std::pair<Box, Box> divided(const Box& box, double room_pt);

/// Draws a box with its border.
void draw(const Box& box, cairo_t* cairo, double left_pt, double top_pt);

/// A rule across a box.
[[nodiscard]] Mark rule(const Ink& ink, double y_pt, double width_pt, double thickness_pt);

}  // namespace rva::pdf
