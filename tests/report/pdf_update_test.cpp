#include "report/pdf/pdf_update.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "report/pdf/pdf_report.hpp"

namespace rva::pdf {
namespace {

std::string report() {
  return pdf_report({.inspection = 7,
                     .title = "bay",
                     .content = Content::of(PartRole::paragraph, Content::text("words")),
                     .last_action_at = "2026-01-01T12:00:00.000Z"},
                    Paper::a4);
}

TEST(PdfUpdate, KeepsTheBytesBeforeItAndIsReadAgain) {
  const std::string before = report();
  PdfUpdate update(before);
  const int page = update.first_page();
  update.extend(page, "/One 1");
  EXPECT_NE(update.add("<< /Two 2 >>"), page);
  const std::string once = std::move(update).finished();
  EXPECT_TRUE(once.starts_with(before));
  PdfUpdate again(once);
  EXPECT_EQ(again.first_page(), page);
  again.extend(page, "/Three 3");
  const std::string twice = std::move(again).finished();
  const std::size_t last = twice.rfind("/Three 3");
  EXPECT_NE(twice.rfind("/One 1", last), std::string::npos) << "the newest state of the object was extended";
  EXPECT_GT(twice.rfind("/One 1"), once.size());
}

TEST(PdfUpdate, WhatIsNoFileOfThisProgramIsRefused) {
  const std::string whole = report();
  EXPECT_THROW(PdfUpdate(""), Error);
  EXPECT_THROW(PdfUpdate("%PDF-1.4\nstartxref\n5\n%%EOF\n"), Error);
  EXPECT_THROW(PdfUpdate("%PDF-1.4\nstartxref\n99999\n%%EOF\n"), Error);
  EXPECT_THROW(PdfUpdate(whole.substr(0, whole.size() / 2)), Error);
  EXPECT_THROW(PdfUpdate(whole).extend(9999, "/One 1"), Error);
}

TEST(PdfReport, AReportWithoutATimeHasTheSameBytes) {
  ReportDocument report{.inspection = 8, .title = "\xff\x01", .content = {}, .last_action_at = "no time"};
  const std::string first = pdf_report(report, Paper::letter);
  EXPECT_EQ(pdf_report(report, Paper::letter), first);
  EXPECT_NE(first.find("(D:19700101000000"), std::string::npos) << "not the time at which it was made";
}

}  // namespace
}  // namespace rva::pdf
