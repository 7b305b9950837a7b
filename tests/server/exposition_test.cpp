#include "server/exposition.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(Exposition, CountsDurationsInAllClassesThatTheyAreBelow) {
  DurationHistogram durations;
  durations.add(0.001);  // the end of a class belongs to it
  durations.add(0.3);
  durations.add(99.0);
  Exposition metrics;
  metrics.family("rva_wait_seconds", "histogram", "For the test.");
  metrics.histogram(durations, {{"code", "200"}});
  const std::string& text = metrics.text();
  for (const char* const line :
       {"# TYPE rva_wait_seconds histogram\n", "rva_wait_seconds_bucket{code=\"200\",le=\"0.001\"} 1\n",
        "rva_wait_seconds_bucket{code=\"200\",le=\"0.25\"} 1\n",
        "rva_wait_seconds_bucket{code=\"200\",le=\"0.5\"} 2\n",
        "rva_wait_seconds_bucket{code=\"200\",le=\"+Inf\"} 3\n",
        "rva_wait_seconds_sum{code=\"200\"} 99.301\n", "rva_wait_seconds_count{code=\"200\"} 3\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST(Exposition, EscapesValuesOfLabels) {
  Exposition metrics;
  metrics.family("rva_name", "gauge", "For the test.");
  metrics.sample(1.0, {{"text", "a\"b\\c\nd"}});
  EXPECT_NE(metrics.text().find("rva_name{text=\"a\\\"b\\\\c\\nd\"} 1\n"), std::string::npos);
}

}  // namespace
}  // namespace rva
