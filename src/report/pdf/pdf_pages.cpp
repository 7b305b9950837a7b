#include "report/pdf/pdf_pages.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace rva::pdf {
namespace {

/// Fills pages from above.
class Pages {
 public:
  explicit Pages(double height_pt) : height_pt_(height_pt) {}

  /// Places boxes of which all but the last keep with the next.
  void place_together(std::span<const Box> boxes) {
    double needed_pt = 0.0;
    for (const Box& box : boxes) needed_pt += distance(box) + box.height_pt;
    // What no page has room for begins here, unless little of it would.
    constexpr double little = 0.25;
    const bool is_divided = needed_pt > height_pt_ && room_pt() > little * height_pt_;
    if (is_begun() && needed_pt > room_pt() && !is_divided) begin_page();
    for (const Box& box : boxes) place(box);
  }

  [[nodiscard]] std::vector<Page> taken() && { return std::move(pages_); }

 private:
  [[nodiscard]] bool is_begun() const { return !pages_.back().empty(); }
  [[nodiscard]] double room_pt() const { return height_pt_ - used_pt_; }
  [[nodiscard]] double distance(const Box& box) const { return is_begun() ? box.above_pt : 0.0; }

  void begin_page() {
    pages_.emplace_back();
    used_pt_ = 0.0;
  }

  void put(const Box& box) {
    const double top_pt = used_pt_ + distance(box);
    used_pt_ = top_pt + box.height_pt;
    pages_.back().push_back({box, top_pt});
  }

  // A box that has no room here is higher than a page, or follows a heading that leaves it too little of one.
  void place(Box box) {
    for (;;) {
      const bool is_fresh = !is_begun();
      if (is_fresh && box.head) put(*box.head);
      auto [part, rest] = divided(box, room_pt() - distance(box));
      if (rest.marks.empty() || (is_fresh && part.marks.empty())) return put(box);
      if (!part.marks.empty()) {
        put(part);
        box = std::move(rest);
      }
      begin_page();
    }
  }

  double height_pt_;
  double used_pt_ = 0.0;
  std::vector<Page> pages_{1};
};

}  // namespace

std::vector<Page> pages_of(const std::vector<Box>& boxes, double height_pt) {
  Pages pages(height_pt);
  for (auto first = boxes.begin(); first != boxes.end();) {
    const auto last = std::find_if(first, boxes.end(), [](const Box& box) { return !box.keeps_with_next; });
    const auto end = last == boxes.end() ? last : last + 1;
    pages.place_together({first, end});
    first = end;
  }
  return std::move(pages).taken();
}

}  // namespace rva::pdf
