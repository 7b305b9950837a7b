#include "core/csv_row.hpp"

#include <gtest/gtest.h>

#include "core/csv_records.hpp"

namespace rva {
namespace {

TEST(CsvRow, IsReadAsItWasWritten) {
  const std::vector<std::string> cells{"plain",      "",         "a,b",   "a \"quoted\" word",
                                       "two\nlines", "line\r\n", "Flügel"};
  const std::vector<CsvRecord> records =
      parse_csv(csv_row(cells) + csv_row({"next", "1", "", "", "", "", ""}), "test");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].fields, cells);
}

TEST(CsvRow, IsNoFormulaInASpreadsheet) {
  for (const std::string formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1"})
    EXPECT_TRUE(csv_row({formula}).find('\'') <= 1) << formula;
  EXPECT_EQ(csv_row({"1-1"}), "1-1\r\n");
}

}  // namespace
}  // namespace rva
