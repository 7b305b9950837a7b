#include "core/event.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(Event, IsOneLineOfAMessageAndFields) {
  EXPECT_EQ(
      event_text({EventLevel::info, "started", "serves the console", {{"robot", "none"}, {"port", "80"}}}),
      "serves the console event=started robot=none port=80");
}

TEST(Event, QuotesValuesThatWouldNotBeRead) {
  EXPECT_EQ(event_text({EventLevel::info, "x", "y", {{"a", "two words"}, {"b", ""}, {"c", "q\"=\n"}}}),
            "y event=x a=\"two words\" b=\"\" c=\"q\\\"=\\\\x0A\"");
}

TEST(Event, CannotBeginAnotherLine) {
  EXPECT_EQ(event_text({EventLevel::info, "x", "a\n<0>b", {}}).find('\n'), std::string::npos);
}

TEST(Event, HasTheLevelsOfSyslog) {
  EXPECT_EQ(journal_prefix(EventLevel::error), "<3>");
  EXPECT_EQ(journal_prefix(EventLevel::warning), "<4>");
  EXPECT_EQ(journal_prefix(EventLevel::info), "<6>");
}

}  // namespace
}  // namespace rva
