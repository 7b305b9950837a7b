#include "core/csv_records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/error.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Fields = std::vector<std::string>;

std::vector<Fields> fields_of(std::string_view text) {
  std::vector<Fields> all;
  for (CsvRecord& record : parse_csv(text, "list")) all.push_back(std::move(record.fields));
  return all;
}

TEST(CsvRecords, AreThoseOfRfc4180) {
  EXPECT_THAT(fields_of("a,b,c\r\nd,,f\r\n"), ElementsAre(Fields{"a", "b", "c"}, Fields{"d", "", "f"}));
  EXPECT_THAT(fields_of("a,b"), ElementsAre(Fields{"a", "b"})) << "the last line needs no end";
  EXPECT_THAT(fields_of("\"a,\"\"b\"\"\r\nc\",d"), ElementsAre(Fields{"a,\"b\"\r\nc", "d"}));
  EXPECT_THAT(fields_of(R"("","")"), ElementsAre(Fields{"", ""}));
  EXPECT_THAT(fields_of(" a , b "), ElementsAre(Fields{" a ", " b "}));
}

TEST(CsvRecords, AreThoseOfOtherSpreadsheets) {
  EXPECT_THAT(fields_of("a;b,c;d\n1;2;3\n"), ElementsAre(Fields{"a", "b,c", "d"}, Fields{"1", "2", "3"}));
  EXPECT_THAT(fields_of("a\tb\nc\td"), ElementsAre(Fields{"a", "b"}, Fields{"c", "d"}));
  EXPECT_THAT(fields_of("\xEF\xBB\xBF"
                        "a,b\n"),
              ElementsAre(Fields{"a", "b"}));
  EXPECT_THAT(fields_of("a\rb"), ElementsAre(Fields{"a"}, Fields{"b"}));
  EXPECT_THAT(fields_of("\n\na\n\n"), ElementsAre(Fields{"a"}));
  EXPECT_TRUE(fields_of("").empty());
}

TEST(CsvRecords, StateTheirLines) {
  const std::vector<CsvRecord> records = parse_csv("a,\"b\nc\"\n\nd", "list");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].line, 1U);
  EXPECT_EQ(records[1].line, 4U);
}

TEST(CsvRecords, RefuseDamage) {
  const auto problem = [](std::string_view text) {
    try {
      static_cast<void>(parse_csv(text, "list"));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_THAT(problem("a\nb,\"c"), HasSubstr("line 2: has a quote that is not closed"));
  EXPECT_THAT(problem("\"a\"b,c"), HasSubstr("text after a closing quote"));
  EXPECT_THAT(problem("a,\xFF"), HasSubstr("UTF-8"));
}

std::string quoted(const std::string& value) {
  std::string cell = "\"";
  for (const char character : value) {
    if (character == '"') cell += '"';
    cell += character;
  }
  return cell + '"';
}

/// Texts and numbers by chance, the same in every run.
class Chance {
 public:
  int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  std::string text() {
    constexpr std::string_view characters = "ab,;\t\"\r\n ";
    std::string text(static_cast<std::size_t>(number(0, 5)), ' ');
    for (char& character : text)
      character = characters[static_cast<std::size_t>(number(0, static_cast<int>(characters.size()) - 1))];
    return text;
  }
  Fields fields() {
    Fields fields(static_cast<std::size_t>(number(2, 4)));
    for (std::string& field : fields) field = text();
    return fields;
  }

 private:
  std::mt19937 random_{20261130};
};

std::string line_of(const Fields& fields) {
  std::string line = quoted(fields.front());
  for (auto field = fields.begin() + 1; field != fields.end(); ++field) line += "," + quoted(*field);
  return line + "\r\n";
}

// Whatever fields contain, they are read as they were written.
TEST(CsvRecords, AreReadAsTheyWereWritten) {
  Chance chance;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::vector<Fields> written{{"first", "second"}, chance.fields(), chance.fields(), chance.fields()};
    std::string text;
    for (const Fields& fields : written) text += line_of(fields);
    EXPECT_EQ(fields_of(text), written) << text;
  }
}

}  // namespace
}  // namespace rva
