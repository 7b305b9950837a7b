#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "store/schema.hpp"
#include "store/sqlite_records.hpp"
#include "tests/store/kept.hpp"

namespace rva {
namespace {

using test::comparison;
using test::finding;
using test::Kept;
using testing::HasSubstr;
using testing::SizeIs;

// The program wrote such files before regions could be left out.
TEST_F(Kept, AFileOfVersion1IsBroughtUpToDate) {
  records_.reset();
  const std::filesystem::path old = folder_ / "old.db";
  {
    SQLite::Database file(old.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.exec(schema);
    file.exec("pragma application_id = 1381384497");
    file.exec("pragma user_version = 1");
    file.exec(
        "insert into inspection values (1, 'N1', 'bay', 'WO', 'Ann', 't0', 't1', 4);"
        "insert into side values (1, 'final', 't0', 'Ann', 'base');"
        "insert into account values ('ann', 'viewer', 'h');"
        "insert into compared_view values (1, 0, 'spatial', 0.9, 0.06, 0.04, 0.8, '[]');"
        "insert into finding values (1, 't1', 1, 0, 1, 'added', '[1,2,3,4]', '[2.5,4]', null, null, null, 7, "
        "9, null);"
        "insert into decision values (1, 1, 't1', 1, 'debris-removed', 'a bolt', 'Bob', 't2')");
  }
  SqliteRecords records(old);
  const Inspection back = *records.find(1);
  ASSERT_THAT(back.findings, SizeIs(1));
  EXPECT_EQ(back.findings[0].decision->note, "a bolt");
  EXPECT_EQ(back.comparison->number, 1);
  EXPECT_EQ(back.comparison->compared_at, "t1");
  EXPECT_EQ(back.findings[0].finding.evidence, Evidence{}) << "depth, as all were";
  EXPECT_EQ(back.final->round, 1);
  EXPECT_EQ(back.comparison->final_round, 1);
  EXPECT_EQ(back.findings[0].decision->round, 1);
  EXPECT_EQ(back.compared.at(0).judged, 0.8);
  EXPECT_EQ(records.accounts().at(0).generation.size(), 32U);
  EXPECT_NO_THROW(records.decide(1, 1, 1, {Verdict::false_alarm, "", "Ann", "t3"}));
  EXPECT_NO_THROW(records.set_comparison(1, comparison(2), {}, {finding(1)}));
  EXPECT_FALSE(back.findings[0].moved_from || back.compared.at(0).coverage.left_out);
  EXPECT_TRUE(back.ignored.empty() && back.planned.empty() && back.compared.at(0).planned.empty());
  EXPECT_NO_THROW(records.set_ignored(1, 0, {{{0, 0}, {1, 0}, {0, 1}}}));
  EXPECT_THAT(records.summaries({.text = "bay n1"}), SizeIs(1));
  EXPECT_EQ(records.add_inspection({}, "t4", 1, {{0, 0}}, 0), 2);
  EXPECT_NO_THROW(SqliteRecords{old}) << "once";
}

TEST_F(Kept, AValueThatIsDamagedIsReported) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  for (const char* const damage :
       {"box = '[1,2'", "box = '[1,2,3]'", "centroid = '{}'", "size_mm = '[\"a\",1]'"}) {
    SQLite::Database((folder_ / "rva.db").string(), SQLite::OPEN_READWRITE)
        .exec(std::string("update finding set ") + damage);
    try {
      static_cast<void>(records_->find(id));
      FAIL() << damage;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("contains a value that this program did not write")) << damage;
    }
  }
}

TEST_F(Kept, AccountsAreAddedReplacedAndRemoved) {
  records_->set_account({"ann", PersonRole::viewer, "h1"});
  records_->set_account({"ann", PersonRole::inspector, "h2"});
  ASSERT_THAT(records_->accounts(), SizeIs(1));
  EXPECT_EQ(records_->accounts()[0].role, PersonRole::inspector);
  const std::string generation = records_->accounts()[0].generation;
  records_->set_account({"ann", PersonRole::inspector, "h2"});
  EXPECT_NE(records_->accounts()[0].generation, generation);
  EXPECT_TRUE(records_->remove_account("ann"));
  EXPECT_FALSE(records_->remove_account("ann"));
}

// As a power cut would: nothing of the process is left to tidy up.
TEST_F(Kept, WhatWasSaidToBeDoneSurvivesAKill) {
  records_.reset();
  const pid_t child = ::fork();
  if (child == 0) {
    SqliteRecords records(folder_ / "rva.db");
    for (int i = 0; i < 3; ++i)
      static_cast<void>(records.add_inspection({"", "", "", "Ann"}, "t", 1, {{0, 0}}, 0));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  open();
  EXPECT_THAT(records_->inspections(), SizeIs(3));
}

std::string refusal(const std::filesystem::path& file) {
  try {
    const SqliteRecords records(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SqliteRecords, RefusesWhatIsNoDatabaseOfOurs) {
  const test::TemporaryFolder folder;
  write_file(folder / "text.db", "no database at all, but long enough to be looked at as one by a reader");
  EXPECT_THAT(refusal(folder / "text.db"), HasSubstr("text.db"));
  SQLite::Database((folder / "other.db").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("create table t (x)");
  EXPECT_THAT(refusal(folder / "other.db"), HasSubstr("another program"));
  EXPECT_THAT(refusal(folder / "missing" / "rva.db"), HasSubstr("rva.db"));
  { const SqliteRecords records(folder / "newer.db"); }
  SQLite::Database((folder / "newer.db").string(), SQLite::OPEN_READWRITE).exec("pragma user_version = 99");
  EXPECT_THAT(refusal(folder / "newer.db"), HasSubstr("newer version"));
}

}  // namespace
}  // namespace rva
