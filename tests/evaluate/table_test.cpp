#include "evaluate/table.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace rva {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Table, AlignsKeysToTheLeftAndColumnsToTheRight) {
  std::vector<TableColumn> keys{{"scene"}};
  std::vector<TableColumn> columns{{"found"}, {"all"}};
  add_row(keys, {"a"});
  add_row(columns, {"1/2", "1234"});
  EXPECT_EQ(table_of(keys, columns),
            "scene  found   all\n"
            "a        1/2  1234\n");
}

TEST(Table, ContinuesBelowWithTheKeysWhereColumnsDoNotFit) {
  std::vector<TableColumn> keys{{"key"}};
  std::vector<TableColumn> columns(9, {std::string(15, 'h')});
  add_row(keys, {"row"});
  add_row(columns, std::vector<std::string>(9, "cell"));
  const std::vector<std::string> lines = lines_of(table_of(keys, columns));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0].size(), 5 + 5 * 17 - 2) << "a sixth column would reach beyond the 100th character";
  EXPECT_EQ(lines[2], "");
  EXPECT_EQ(lines[3].size(), 5 + 4 * 17 - 2);
  EXPECT_TRUE(lines[1].starts_with("row ") && lines[4].starts_with("row "));
}

TEST(Table, FitsWhateverTheCellsAre) {
  std::vector<TableColumn> keys{{"scene"}, {"captures"}};
  std::vector<TableColumn> columns{{"one"}, {"two"}};
  add_row(keys, {std::string(300, 's'), "4"});
  add_row(columns, {std::string(300, 'x'), std::string(300, 'y')});
  for (const std::string& line : lines_of(table_of(keys, columns))) EXPECT_LE(line.size(), table_width);
}

}  // namespace
}  // namespace rva
