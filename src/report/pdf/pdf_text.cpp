#include "report/pdf/pdf_text.hpp"

#include <utf8.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva::pdf {
namespace {

constexpr const char* family = "Liberation Sans, DejaVu Sans, Noto Sans, sans-serif";
constexpr const char* code_family = "DejaVu Sans Mono, Liberation Mono, monospace";
constexpr double code_size = 7.0 / 8.0;  // of the words around it: its letters are large

template <typename Object>
std::shared_ptr<Object> owned(Object* object) {
  return {object, [](Object* unused) { g_object_unref(unused); }};
}

/// A person's words, isolated: their direction of writing must not affect what follows, and what they contain
/// cannot end that. Each line is isolated anew, since a line break ends all isolates.
class Isolated {
 public:
  explicit Isolated(std::string_view words) {
    begin_line();
    for (auto at = words.begin(); at != words.end();) add(static_cast<char32_t>(utf8::next(at, words.end())));
    end_line();
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static constexpr char32_t first_isolate = 0x2066;  // left-to-right, right-to-left, first strong
  static constexpr char32_t last_isolate = 0x2068;
  static constexpr char32_t end_of_isolate = 0x2069;
  static constexpr char32_t end_of_paragraph = 0x2029;

  void put(char32_t character) { utf8::append(character, std::back_inserter(text_)); }

  void begin_line() {
    put(last_isolate);
    open_ = 1;
  }

  void end_line() {
    for (; open_ > 0; --open_) put(end_of_isolate);
  }

  void add(char32_t character) {
    if (character == '\n' || character == end_of_paragraph) {
      end_line();
      put('\n');
      begin_line();
      return;
    }
    if (character == end_of_isolate && open_ == 1) return;
    if (character >= first_isolate && character <= last_isolate) ++open_;
    if (character == end_of_isolate) --open_;
    put(character);
  }

  std::string text_;
  int open_ = 0;
};

/// Text with its attributes while it grows.
class StyledText {
 public:
  explicit StyledText(const TextStyle& style) : style_(style) {
    pango_attr_list_insert(attributes_, pango_attr_insert_hyphens_new(FALSE));
    if (style.is_bold) pango_attr_list_insert(attributes_, pango_attr_weight_new(PANGO_WEIGHT_BOLD));
    if (style.is_italic) pango_attr_list_insert(attributes_, pango_attr_style_new(PANGO_STYLE_ITALIC));
  }
  ~StyledText() { pango_attr_list_unref(attributes_); }
  StyledText(const StyledText&) = delete;
  StyledText& operator=(const StyledText&) = delete;

  void add(const Content& words) {
    for (const ReportPart& part : words.parts()) add(part);
  }

  void set(PangoLayout* layout) const {
    pango_layout_set_text(layout, text_.data(), static_cast<int>(text_.size()));
    pango_layout_set_attributes(layout, attributes_);
  }

 private:
  void add(const ReportPart& part) {
    const std::size_t start = text_.size();
    if (part.role == PartRole::text) text_ += part.words;
    if (part.role == PartRole::typed) text_ += Isolated(part.words).text();
    add(part.inside);
    if (part.role == PartRole::strong) add_from(start, pango_attr_weight_new(PANGO_WEIGHT_BOLD));
    if (part.role != PartRole::code) return;
    add_from(start, pango_attr_family_new(code_family));
    add_from(start, pango_attr_size_new(static_cast<int>(code_size * style_.size_pt * PANGO_SCALE)));
  }

  // To the end of the text as it is now.
  void add_from(std::size_t start, PangoAttribute* attribute) {
    attribute->start_index = static_cast<guint>(start);
    attribute->end_index = static_cast<guint>(text_.size());
    pango_attr_list_insert(attributes_, attribute);
  }

  TextStyle style_;
  std::string text_;
  PangoAttrList* attributes_ = pango_attr_list_new();
};

double points(int pango_units) { return static_cast<double>(pango_units) / PANGO_SCALE; }

// A mark for each line. A line is a part of its layout, which each mark keeps.
Box box_of(const std::shared_ptr<PangoLayout>& layout, const Ink& ink) {
  Box box;
  PangoLayoutIter* const at = pango_layout_get_iter(layout.get());
  do {
    PangoRectangle extents{};
    pango_layout_iter_get_line_extents(at, nullptr, &extents);
    const double x_pt = points(extents.x);
    const double baseline_pt = points(pango_layout_iter_get_baseline(at) - extents.y);
    PangoLayoutLine* const line = pango_layout_iter_get_line_readonly(at);
    box.marks.push_back({.y_pt = points(extents.y),
                         .height_pt = points(extents.height),
                         .draw = [=](cairo_t* cairo, double left_pt, double top_pt) {
                           static_cast<void>(layout);
                           cairo_set_source_rgb(cairo, ink.red, ink.green, ink.blue);
                           cairo_move_to(cairo, left_pt + x_pt, top_pt + baseline_pt);
                           pango_cairo_show_layout_line(cairo, line);
                         }});
    box.height_pt = points(extents.y + extents.height);
  } while (pango_layout_iter_next_line(at) != FALSE);
  pango_layout_iter_free(at);
  return box;
}

void require_font(PangoFontMap* fonts, PangoContext* context) {
  PangoFontDescription* const wanted = pango_font_description_from_string(family);
  PangoFont* const font = pango_font_map_load_font(fonts, context, wanted);
  pango_font_description_free(wanted);
  if (font == nullptr) throw Error("PDF", "needs a font, and none is installed", "install fonts-liberation");
  g_object_unref(font);
}

// Widths that are rounded down by a unit would break a line that just fits.
int pango_width(double width_pt) {
  return static_cast<int>(std::ceil(std::max(1.0, width_pt) * PANGO_SCALE));
}

}  // namespace

TextSetter::TextSetter() {
  const auto fonts = owned(pango_cairo_font_map_new());
  constexpr double dots_per_inch = 72.0;  // a unit of the pages is a point
  pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts.get()), dots_per_inch);
  context_ = owned(pango_font_map_create_context(fonts.get()));
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context_.get(), FALSE);
  pango_context_set_language(context_.get(), pango_language_from_string("en"));
  require_font(fonts.get(), context_.get());
}

std::shared_ptr<PangoLayout> TextSetter::layout_of(const Content& words, const TextStyle& style) const {
  auto layout = owned(pango_layout_new(context_.get()));
  PangoFontDescription* const font = pango_font_description_from_string(family);
  pango_font_description_set_absolute_size(font, style.size_pt * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font);
  pango_font_description_free(font);
  pango_layout_set_auto_dir(layout.get(), FALSE);
  pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
  StyledText text(style);
  text.add(words);
  text.set(layout.get());
  return layout;
}

Box TextSetter::lines(const Content& words, const TextStyle& style, double width_pt) const {
  const auto layout = layout_of(words, style);
  pango_layout_set_width(layout.get(), pango_width(width_pt));
  return box_of(layout, style.ink);
}

Box TextSetter::one_line(const Content& words, const TextStyle& style, double width_pt) const {
  const auto layout = layout_of(words, style);
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  pango_layout_set_width(layout.get(), pango_width(width_pt));
  return box_of(layout, style.ink);
}

double TextSetter::width_pt(const Content& words, const TextStyle& style) const {
  int width = 0;
  pango_layout_get_size(layout_of(words, style).get(), &width, nullptr);
  return points(width);
}

bool is_inline(PartRole role) {
  return role == PartRole::text || role == PartRole::typed || role == PartRole::strong ||
         role == PartRole::code;
}

}  // namespace rva::pdf
