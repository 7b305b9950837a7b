#include "core/date_time.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace rva {
namespace {

std::string text_of(std::int64_t ms_since_1970) {
  return iso_8601(std::chrono::system_clock::time_point(std::chrono::milliseconds(ms_since_1970)));
}

// From `date -u -d @SECONDS`.
TEST(DateTime, IsThatOfTheCalendarInUtc) {
  EXPECT_EQ(text_of(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(text_of(951'827'696'789), "2000-02-29T12:34:56.789Z");
  EXPECT_EQ(text_of(1'000'000'000'007), "2001-09-09T01:46:40.007Z");
  EXPECT_EQ(text_of(4'107'542'399'999), "2100-02-28T23:59:59.999Z");
  EXPECT_EQ(text_of(4'107'542'400'000), "2100-03-01T00:00:00.000Z") << "2100 is no leap year";
}

TEST(DateTime, IsRoundedDownBefore1970Too) {
  EXPECT_EQ(text_of(-1), "1969-12-31T23:59:59.999Z");
  EXPECT_EQ(text_of(-1000), "1969-12-31T23:59:59.000Z");
}

TEST(DateTime, DoesNotDependOnTheTimeZone) {
  ASSERT_EQ(::setenv("TZ", "XYZ-5:45", 1), 0);
  ::tzset();
  const std::string text = text_of(0);
  const auto ns = ns_since_1970("1970-01-01T00:00:01.000Z");
  ::unsetenv("TZ");
  ::tzset();
  EXPECT_EQ(text, "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(ns, 1'000'000'000U);
}

TEST(DateTime, IsReadAsItWasWritten) {
  constexpr std::uint64_t ns_per_ms = 1'000'000;
  for (std::int64_t ms = 0; ms < 1000; ++ms) {
    const std::int64_t moment_ms = 1'795'000'000'000 + ms;
    EXPECT_EQ(ns_since_1970(text_of(moment_ms)), static_cast<std::uint64_t>(moment_ms) * ns_per_ms)
        << text_of(moment_ms);
  }
}

TEST(DateTime, IsReadWithFewerAndMoreDigits) {
  EXPECT_EQ(ns_since_1970("2001-09-09T01:46:40Z"), 1'000'000'000'000'000'000U);
  EXPECT_EQ(ns_since_1970("2001-09-09T01:46:40.5Z"), 1'000'000'000'500'000'000U);
  EXPECT_EQ(ns_since_1970("2001-09-09T01:46:40.123456789Z"), 1'000'000'000'123'456'789U);
}

TEST(DateTime, OfAnyOtherTextIsUnknown) {
  for (const char* const text :
       {"", "Z", "2001-09-09", "2001-09-09T01:46:40", "2001-09-09T01:46:40.5", "2001-09-09T01:46:40+01:00",
        "2001-09-09T01:46:40Z ", "2001-09-09T01:46:40.Z", "2001-09-09T01:46:40.5e3Z",
        "2001-09-09T01:46:40.-5Z", "2001-13-09T01:46:40Z", "2001-09-09T25:46:40Z", "2001-09-09 01:46:40Z",
        "yesterday", "1969-12-31T23:59:59Z"})
    EXPECT_FALSE(ns_since_1970(text)) << text;
}

}  // namespace
}  // namespace rva
