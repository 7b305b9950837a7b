// Pictures side by side.
#pragma once

#include "report/pdf/pdf_blocks.hpp"

namespace rva::pdf {

/// A picture as wide as there is room, or smaller where it would be too high.
[[nodiscard]] Box picture_box(const JpegPicture& picture, double width_pt);

/// Figures in rows of `columns`.
[[nodiscard]] std::vector<Box> figure_rows(const Content& figures, int columns, const Setting& setting);

}  // namespace rva::pdf
