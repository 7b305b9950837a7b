// Metrics as text, in the exposition format 0.0.4 of Prometheus.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/duration_histogram.hpp"

namespace rva {

/// Writes metrics one family after the other.
class Exposition {
 public:
  /// Names of labels and their values, which may contain any text.
  using Labels = std::vector<std::pair<std::string_view, std::string>>;

  /// Begins a family, whose samples follow.
  /// @param type "counter", "gauge" or "histogram"
  void family(std::string_view name, std::string_view type, std::string_view help);
  /// A sample of the family.
  void sample(double value, const Labels& labels = {});
  /// The samples of a histogram of the family.
  void histogram(const DurationHistogram& durations, const Labels& labels);
  /// A family with one sample without labels.
  void single(std::string_view name, std::string_view type, std::string_view help, double value);

  /// All that was written.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void line(std::string_view suffix, const Labels& labels, double value);

  std::string family_;
  std::string text_;
};

}  // namespace rva
