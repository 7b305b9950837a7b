#include "audit/statement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace rva {
namespace {

Statement statement() {
  return {{12, "N1 \"quoted\"", "bay \u00fc", "W\n1"},
          "2026-01-01T00:00:00.000Z",
          {"ann+1+key", "bob+2+key"},
          "log+3+key",
          {{"data/inspection.json", sha256("a")}, {"bagit.txt", sha256("b")}}};
}

// The names of in-toto's specification, spec/v1/statement.md.
TEST(Statement, IsOneOfInToto) {
  const nlohmann::json json = nlohmann::json::parse(text_of(statement()));
  EXPECT_EQ(json["_type"], "https://in-toto.io/Statement/v1");
  EXPECT_EQ(json["predicateType"], inspection_predicate_type);
  ASSERT_EQ(json["subject"].size(), 2U);
  EXPECT_EQ(json["subject"][0]["name"], "bagit.txt");
  EXPECT_EQ(json["subject"][1]["digest"]["sha256"], hex_of(bytes_of(sha256("a"))));
  EXPECT_EQ(json["predicate"]["aircraft"], "N1 \"quoted\"");
}

TEST(Statement, IsReadAsItWasWritten) {
  const std::string text = text_of(statement());
  const Statement read = parse_statement(text, "statement");
  EXPECT_EQ(read.inspection.number, 12);
  EXPECT_EQ(read.inspection.work_order, "W\n1");
  EXPECT_EQ(read.made_at, "2026-01-01T00:00:00.000Z");
  EXPECT_EQ(read.signers, statement().signers);
  EXPECT_EQ(read.log, "log+3+key");
  EXPECT_EQ(read.subjects, statement().subjects);
}

TEST(Statement, EveryOtherTextIsRefused) {
  const std::string text = text_of(statement());
  const auto replaced = [&](const std::string& part, const std::string& by) {
    std::string changed = text;
    return changed.replace(changed.find(part), part.size(), by);
  };
  const std::string digest = hex_of(bytes_of(sha256("a")));
  const std::vector<std::string> others{
      "",
      "{}",
      "[]",
      text + ' ',
      ' ' + text,
      text.substr(1),
      replaced("Statement/v1", "Statement/v2"),
      replaced("record:v1", "record:v2"),
      replaced(digest, digest.substr(2)),
      replaced("\"subject\":[", "\"subject\":{"),
      replaced("\"subject\":[", "\"subject\":[1,"),
      replaced("data/inspection.json", "bagit.txt"),  // two of one name
      replaced("\"inspection\":12", "\"inspection\":12.5"),
      replaced("[\"ann", "[1,\"ann"),
      replaced("\"signers\"", "\"signer\""),
      replaced("{\"_type\"", "{\"x\":1,\"_type\""),
      replaced("\"made_at\":\"2026", "\"made_at\":\"1\",\"made_at\":\"2026")};
  for (const std::string& bad : others)
    EXPECT_THROW(static_cast<void>(parse_statement(bad, "statement")), Error) << bad;
}

}  // namespace
}  // namespace rva
