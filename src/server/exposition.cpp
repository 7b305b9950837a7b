#include "server/exposition.hpp"

#include <fmt/format.h>

namespace rva {
namespace {

std::string escaped(std::string_view value) {
  std::string text;
  for (const char c : value) {
    if (c == '\n') {
      text += "\\n";
      continue;
    }
    if (c == '\\' || c == '"') text += '\\';
    text += c;
  }
  return text;
}

std::string label_text(const Exposition::Labels& labels) {
  std::string text;
  for (const auto& [name, value] : labels)
    text += fmt::format("{}{}=\"{}\"", text.empty() ? "" : ",", name, escaped(value));
  return text.empty() ? text : "{" + text + "}";
}

}  // namespace

void Exposition::family(std::string_view name, std::string_view type, std::string_view help) {
  family_ = name;
  text_ += fmt::format("# HELP {} {}\n# TYPE {} {}\n", name, help, name, type);
}

void Exposition::line(std::string_view suffix, const Labels& labels, double value) {
  text_ += fmt::format("{}{}{} {}\n", family_, suffix, label_text(labels), value);
}

void Exposition::sample(double value, const Labels& labels) { line("", labels, value); }

// The format counts each duration in all classes whose end is not below it.
void Exposition::histogram(const DurationHistogram& durations, const Labels& labels) {
  double count = 0.0;
  Labels with_bound = labels;
  with_bound.emplace_back("le", "");
  for (std::size_t i = 0; i < durations.counts.size(); ++i) {
    count += static_cast<double>(durations.counts.at(i));
    with_bound.back().second =
        i < duration_bounds_s.size() ? fmt::format("{}", duration_bounds_s.at(i)) : "+Inf";
    line("_bucket", with_bound, count);
  }
  line("_sum", labels, durations.sum_s);
  line("_count", labels, count);
}

void Exposition::single(std::string_view name, std::string_view type, std::string_view help, double value) {
  family(name, type, help);
  sample(value);
}

}  // namespace rva
