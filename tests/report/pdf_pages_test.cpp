#include "report/pdf/pdf_pages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "report/pdf/pdf_table.hpp"

namespace rva::pdf {
namespace {

constexpr double page_pt = 100.0;

// Lines of 10 points.
Box box_of(int lines, bool keeps_with_next = false) {
  Box box;
  for (int k = 0; k < lines; ++k)
    box.marks.push_back({.y_pt = 10.0 * k, .height_pt = 10.0, .draw = [](cairo_t*, double, double) {}});
  box.height_pt = 10.0 * lines;
  box.keeps_with_next = keeps_with_next;
  return box;
}

std::vector<std::size_t> lines_by_page(const std::vector<Page>& pages) {
  std::vector<std::size_t> lines;
  for (const Page& page : pages) {
    lines.push_back(0);
    for (const PlacedBox& placed : page) lines.back() += placed.box.marks.size();
  }
  return lines;
}

TEST(PdfPages, WhatFitsAPageIsNotDivided) {
  EXPECT_EQ(lines_by_page(pages_of({box_of(6), box_of(6), box_of(4)}, page_pt)),
            (std::vector<std::size_t>{6, 10}));
  EXPECT_EQ(lines_by_page(pages_of({}, page_pt)), std::vector<std::size_t>{0});
}

TEST(PdfPages, AHeadingIsOnThePageOfWhatFollows) {
  EXPECT_EQ(lines_by_page(pages_of({box_of(7), box_of(1, true), box_of(3)}, page_pt)),
            (std::vector<std::size_t>{7, 4}));
  EXPECT_EQ(lines_by_page(pages_of({box_of(7), box_of(1, true)}, page_pt)), std::vector<std::size_t>{8});
}

TEST(PdfPages, WhatIsHigherThanAPageBeginsWhereItIs) {
  EXPECT_EQ(lines_by_page(pages_of({box_of(2), box_of(25), box_of(1)}, page_pt)),
            (std::vector<std::size_t>{10, 10, 8}));
  EXPECT_EQ(lines_by_page(pages_of({box_of(9), box_of(1, true), box_of(25)}, page_pt)),
            (std::vector<std::size_t>{9, 10, 10, 6}))
      << "a heading with no line of it would be an orphan";
}

TEST(PdfPages, ATableThatIsContinuedRepeatsItsHead) {
  const auto head = std::make_shared<Box>(box_of(1, true));
  std::vector<Box> boxes{*head};
  for (int row = 0; row < 12; ++row) {
    boxes.push_back(box_of(1));
    boxes.back().head = head;
  }
  const std::vector<Page> pages = pages_of(boxes, page_pt);
  EXPECT_EQ(lines_by_page(pages), (std::vector<std::size_t>{10, 4})) << "nine rows, and a head and three";
}

TEST(PdfPages, AMarkHigherThanAPageIsPlacedAlone) {
  Box high = box_of(1);
  high.marks[0].height_pt = high.height_pt = 2.0 * page_pt;
  EXPECT_EQ(lines_by_page(pages_of({box_of(1), high, box_of(1)}, page_pt)),
            (std::vector<std::size_t>{1, 1, 1}));
}

TEST(PdfPages, NothingIsLostOrCutWhateverTheBoxes) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Box> boxes;
    std::size_t lines = 0;
    for (auto count = random() % 20; count > 0; --count) {
      boxes.push_back(box_of(static_cast<int>(1 + random() % 30), random() % 4 == 0));
      boxes.back().above_pt = static_cast<double>(random() % 8);
      lines += boxes.back().marks.size();
    }
    const std::vector<Page> pages = pages_of(boxes, page_pt);
    const std::vector<std::size_t> placed = lines_by_page(pages);
    ASSERT_EQ(std::accumulate(placed.begin(), placed.end(), std::size_t{0}), lines);
    for (const Page& page : pages)
      for (const PlacedBox& box : page)
        for (const Mark& mark : box.box.marks) {
          ASSERT_GE(box.top_pt + mark.y_pt, 0.0);
          ASSERT_LE(box.top_pt + mark.y_pt + mark.height_pt, page_pt + 1e-9);
        }
  }
}

TEST(PdfTable, ColumnsAreAsWideAsTheirContentsWhereThereIsRoom) {
  EXPECT_EQ(column_widths({10, 20, 30}, 100), (std::vector<double>{10, 20, 70})) << "the last has the rest";
  EXPECT_EQ(column_widths({10, 200, 300}, 100), (std::vector<double>{10, 45, 45})) << "wide ones share";
  EXPECT_EQ(column_widths({300, 10}, 100), (std::vector<double>{90, 10}));
  EXPECT_TRUE(column_widths({}, 100).empty());
}

}  // namespace
}  // namespace rva::pdf
