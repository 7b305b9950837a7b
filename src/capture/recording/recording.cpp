#include "capture/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "capture/recording/compressed_image.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {

bool Recording::is_compressed(std::string_view topic) const {
  const auto found = topics().find(topic);
  return found != topics().end() && is_compressed_image(found->second.type);
}

const std::vector<RecordedMessage>& Recording::messages(std::string_view topic) const {
  static const std::vector<RecordedMessage> none;
  const auto found = topics().find(topic);
  return found == topics().end() ? none : found->second.messages;
}

std::vector<RecordedMessage> Recording::messages_at(std::string_view topic, std::uint64_t time_ns) const {
  const std::vector<RecordedMessage>& all = messages(topic);
  return {std::ranges::lower_bound(all, time_ns, {}, &RecordedMessage::time_ns),
          std::ranges::upper_bound(all, time_ns, {}, &RecordedMessage::time_ns)};
}

void Recording::for_each_below(
    const std::string& beginning,
    const std::function<void(std::string_view, const RecordedMessage&)>& use) const {
  for (auto topic = topics().lower_bound(beginning);
       topic != topics().end() && topic->first.starts_with(beginning); ++topic) {
    if (!topic->second.messages.empty())
      use(std::string_view(topic->first).substr(beginning.size()), topic->second.messages.front());
  }
}

std::optional<double> decimal_number(std::string_view text) {
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool sound = parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
  return sound && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<std::string> setting_of(std::string_view below_options) {
  constexpr std::string_view value = "/value";
  if (!below_options.ends_with(value)) return std::nullopt;
  below_options.remove_suffix(value.size());
  std::string name(below_options);
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::vector<StaticTransform> transforms_of(
    const std::vector<RecordedMessage>& messages,
    const std::function<std::vector<StaticTransform>(const RecordedMessage&)>& parse) {
  std::vector<StaticTransform> all;
  for (const RecordedMessage& message : messages) std::ranges::move(parse(message), std::back_inserter(all));
  return all;
}

Error lacks_intrinsics(const std::string& source, const std::string& topic) {
  return {source, "lacks " + printable(topic), "record it, too, or give the intrinsics (fx, fy, cx, cy)"};
}

Intrinsics with_lens(Intrinsics camera, std::string_view model, const std::vector<double>& coefficients,
                     std::string_view source) {
  std::string name(model);
  std::ranges::transform(name, name.begin(), [](char letter) {
    return letter == ' '                    ? '_'
           : letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                            : letter;
  });
  if (name == "plumb_bob") name = name_of(Distortion::brown_conrady);  // its name in ROS
  const bool straight = std::ranges::all_of(coefficients, [](double number) { return number == 0.0; });
  const auto known = value_of<Distortion>(name);
  if (!known && !straight) {
    throw Error(std::string(source), fmt::format("the distortion model '{}' is unknown", printable(name)),
                "record it again");
  }
  camera.distortion = straight ? Distortion::none : *known;
  std::ranges::copy_n(coefficients.begin(),
                      static_cast<std::ptrdiff_t>(std::min(coefficients.size(), camera.coefficients.size())),
                      camera.coefficients.begin());
  try {
    camera.check();
  } catch (const Error& error) {
    throw Error(std::string(source), fmt::format("camera info: {} {}", error.source(), error.problem()),
                "record it again");
  }
  return camera;
}

}  // namespace rva
