#include "report/report_content.hpp"

#include <gtest/gtest.h>

#include "report/report_html.hpp"

namespace rva {
namespace {

TEST(ReportContent, TablesHaveAHeadForEveryColumn) {
  const Content table = content_of({.role = PartRole::events_table,
                                    .head = {Content::text("a"), Content::text("b")},
                                    .rows = {{Content::text("1"), Content::typed("<2>")}}});
  EXPECT_EQ(html_of(table).str(),
            "<table class=\"events\"><thead><tr><th>a</th><th>b</th></tr></thead><tbody><tr><td>1</td><td>"
            "<bdi class=\"typed\">&lt;2&gt;</bdi></td></tr></tbody></table>");
}

TEST(ReportContent, PartsAreCountedAtAnyDepth) {
  const Content reason = Content::of(PartRole::missing, Content::text("damaged"));
  const Content cell = Content::of(PartRole::finding, Content::text("x") + reason) + reason;
  EXPECT_EQ(count_of(PartRole::missing, cell + Content::of(PartRole::settings, cell)), 4U);
  EXPECT_EQ(count_of(PartRole::missing, Content()), 0U);
}

TEST(ReportContent, APictureHasItsSize) {
  const Content picture = Content::picture(ColorImage(12, 7), "a view");
  ASSERT_EQ(picture.parts().size(), 1U);
  EXPECT_EQ(picture.parts()[0].picture.width_px, 12);
  EXPECT_EQ(picture.parts()[0].picture.height_px, 7);
  EXPECT_EQ(picture.parts()[0].words, "a view");
}

}  // namespace
}  // namespace rva
