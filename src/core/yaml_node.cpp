#include "core/yaml_node.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr std::size_t most_items = 10000;
constexpr std::size_t most_quoted = 60;

// Quotes text for a message: on one line, and shortened if long.
std::string quoted(const std::string& text) {
  const bool is_long = text.size() > most_quoted;
  return fmt::format("\"{}{}\"", printable(text.substr(0, most_quoted)), is_long ? "..." : "");
}

template <typename Number>
std::optional<Number> parsed(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc{} || rest != end) return std::nullopt;
  return value;
}

// Ignores all events of a document, to read past it.
class Deaf final : public YAML::EventHandler {
  using Text = const std::string&;
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, Text, YAML::anchor_t, Text) override {}
  void OnSequenceStart(const YAML::Mark&, Text, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, Text, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

// YAML::Load() would ignore further documents; YAML::LoadAll() never returns if a document begins
// with a comma.
void require_one_document(const std::string& text, const std::string& source) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Deaf deaf;
  if (!parser.HandleNextDocument(deaf)) throw Error(source + ":1", "empty", "check the path");
  if (parser)
    throw Error(source + ":1", "continues after the end of its YAML document",
                "keep only the first document");
}

Error syntax_error(const std::string& source, const YAML::Exception& error) {
  const int line = error.mark.is_null() ? 1 : error.mark.line + 1;
  return {fmt::format("{}:{}", source, line), fmt::format("not YAML ({})", error.msg), "correct the file"};
}

}  // namespace

YamlNode YamlNode::parse(const std::string& text, const std::string& source) {
  try {
    require_one_document(text, source);
    return {YAML::Load(text), std::make_shared<const std::string>(source), {}};
  } catch (const YAML::Exception& error) {
    throw syntax_error(source, error);
  }
}

YamlNode::YamlNode(const YAML::Node& node, std::shared_ptr<const std::string> file, std::string field)
    : node_(node), file_(std::move(file)), field_(std::move(field)) {}

YamlNode YamlNode::child(const YAML::Node& node, std::string_view key) const {
  return {node, file_, field_.empty() ? std::string(key) : fmt::format("{}.{}", field_, key)};
}

std::string YamlNode::source() const {
  return fmt::format("{}:{}", *file_, std::max(node_.Mark().line, 0) + 1);
}

Error YamlNode::error(std::string_view problem, std::string remedy) const {
  return {source(), field_.empty() ? std::string(problem) : fmt::format("field {}: {}", field_, problem),
          std::move(remedy)};
}

void YamlNode::allow_only(std::initializer_list<std::string_view> keys) const {
  if (!node_.IsMap()) throw error("not a list of `key: value`");
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
    const YamlNode named(entry.first, file_, field_);
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw named.error(fmt::format("unknown key {}", quoted(key)),
                        fmt::format("known here: {}", fmt::join(keys, ", ")));
    if (!seen.insert(key).second)
      throw named.error(fmt::format("key {} given twice", quoted(key)), "remove one");
  }
}

bool YamlNode::has(const char* key) const { return node_.IsMap() && node_[key].IsDefined(); }

YamlNode YamlNode::at(const char* key) const {
  if (!has(key)) throw error(fmt::format("key \"{}\" is missing", key), "add it");
  return child(node_[key], key);
}

std::optional<YamlNode> YamlNode::find(const char* key) const {
  return has(key) ? std::optional(at(key)) : std::nullopt;
}

std::vector<YamlNode> YamlNode::items() const {
  if (node_.IsNull()) return {};
  if (!node_.IsSequence()) throw error("not a list", "write [a, b] or one line `- ...` for each");
  if (node_.size() > most_items) throw error(fmt::format("more than {} entries", most_items));
  std::vector<YamlNode> list;
  for (std::size_t k = 0; k < node_.size(); ++k)
    list.push_back({node_[k], file_, fmt::format("{}[{}]", field_, k)});
  return list;
}

std::vector<double> YamlNode::numbers(std::size_t count, NumberRange range) const {
  const std::vector<YamlNode> list = items();
  if (list.size() != count) throw error(fmt::format("{} entries, not {}", list.size(), count));
  std::vector<double> values;
  for (const YamlNode& item : list) values.push_back(item.number(range));
  return values;
}

std::string YamlNode::scalar(std::string_view kind) const {
  if (!node_.IsScalar()) throw error(fmt::format("not {}", kind));
  return node_.Scalar();
}

double YamlNode::number(NumberRange range) const {
  const std::string text = scalar("a number");
  const std::optional<double> value = parsed<double>(text);
  if (!value || !std::isfinite(*value)) throw error(fmt::format("{} is not a number", quoted(text)));
  if (*value < range.low || *value > range.high)
    throw error(fmt::format("{} is out of range", quoted(text)),
                fmt::format("use {} to {}", range.low, range.high));
  return *value;
}

int YamlNode::integer(int low, int high) const {
  const std::string text = scalar("a whole number");
  const std::optional<int> value = parsed<int>(text);
  if (!value) throw error(fmt::format("{} is not a whole number, or is too large", quoted(text)));
  if (*value < low || *value > high)
    throw error(fmt::format("{} is out of range", quoted(text)), fmt::format("use {} to {}", low, high));
  return *value;
}

std::uint64_t YamlNode::seed() const {
  const std::string text = scalar("a whole number");
  const std::optional<std::uint64_t> value = parsed<std::uint64_t>(text);
  if (!value) throw error(fmt::format("{} is not a whole number from 0 to 2^64 - 1", quoted(text)));
  return *value;
}

bool YamlNode::boolean() const {
  const std::string text = scalar("true or false");
  if (text != "true" && text != "false") throw error(fmt::format("{} is not true or false", quoted(text)));
  return text == "true";
}

std::string YamlNode::text() const {
  std::string value = scalar("text");
  if (value.empty()) throw error("empty");
  return value;
}

std::size_t YamlNode::choice(std::string_view what, std::span<const std::string_view> names) const {
  const std::string name = text();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw error(fmt::format("unknown {} {}", what, quoted(name)),
                fmt::format("use one of: {}", fmt::join(names, ", ")));
  return static_cast<std::size_t>(found - names.begin());
}

void YamlNode::read(const char* key, double& value, NumberRange range) const {
  if (const auto field = find(key)) value = field->number(range);
}

void YamlNode::read(const char* key, int& value, int low, int high) const {
  if (const auto field = find(key)) value = field->integer(low, high);
}

void YamlNode::read(const char* key, bool& value) const {
  if (const auto field = find(key)) value = field->boolean();
}

}  // namespace rva
