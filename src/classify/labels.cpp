#include "classify/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

std::string trimmed(const std::string& line) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::vector<std::string> read_labels(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  const auto refuse = [&](const std::string& problem, const char* remedy) {
    throw Error(printable(file), problem, remedy);
  };
  if (!is_utf8(text)) refuse("is no text in UTF-8", "give a text file with one class name a line");
  std::vector<std::string> labels;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) labels.push_back(trimmed(line));
  while (!labels.empty() && labels.back().empty()) labels.pop_back();
  if (labels.empty()) refuse("names no class", "give a text file with one class name a line");
  for (auto label = labels.begin(); label != labels.end(); ++label) {
    const auto line = label - labels.begin() + 1;
    if (label->empty()) refuse(fmt::format("line {} is empty", line), "name each class of the model");
    if (std::find(labels.begin(), label, *label) != label)
      refuse(fmt::format("line {} has the name of an earlier line, {}", line, printable(*label)),
             "name each class differently");
  }
  return labels;
}

}  // namespace rva
