// Boxes on pages.
#pragma once

#include <vector>

#include "report/pdf/pdf_box.hpp"

namespace rva::pdf {

/// A box on a page.
struct PlacedBox {
  Box box;
  double top_pt = 0.0;  ///< from the upper end of the page's area
};

/// What a page contains.
using Page = std::vector<PlacedBox>;

/// Places boxes on as few pages as they need in their order. A box that fits a page is not divided, and one
/// that keeps with the next is on the page on which that begins.
/// @param height_pt of the area of a page
/// @return one page at least
[[nodiscard]] std::vector<Page> pages_of(const std::vector<Box>& boxes, double height_pt);

}  // namespace rva::pdf
