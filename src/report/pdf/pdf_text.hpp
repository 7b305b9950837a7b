// Words set as lines, in any script.
#pragma once

#include <pango/pangocairo.h>

#include <memory>

#include "report/pdf/pdf_box.hpp"
#include "report/report_content.hpp"

namespace rva::pdf {

inline constexpr double pt_per_mm = 72.0 / 25.4;

/// How words appear. `strong` and `code` within them differ from it.
struct TextStyle {
  double size_pt = 9.0;
  Ink ink{};
  bool is_bold = false;
  bool is_italic = false;
};

/// Sets words with the fonts that are installed: a character that the report's font lacks is taken from
/// another, and one that no font has is shown as its number in a frame.
class TextSetter {
 public:
  /// @throws Error when no font is installed
  TextSetter();

  /// Lines no wider than `width_pt`, a mark for each. Words that are wider are broken anywhere.
  /// @param words parts within a line; others are left out
  [[nodiscard]] Box lines(const Content& words, const TextStyle& style, double width_pt) const;

  /// One line, cut off with an ellipsis where it is wider.
  [[nodiscard]] Box one_line(const Content& words, const TextStyle& style, double width_pt) const;

  /// The width without line breaks but those in the words.
  [[nodiscard]] double width_pt(const Content& words, const TextStyle& style) const;

 private:
  [[nodiscard]] std::shared_ptr<PangoLayout> layout_of(const Content& words, const TextStyle& style) const;

  std::shared_ptr<PangoContext> context_;
};

/// Whether a part is within a line.
[[nodiscard]] bool is_inline(PartRole role);

}  // namespace rva::pdf
