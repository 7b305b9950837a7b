#include "camera/check_standard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.hpp"
#include "core/json_object.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

enum class Limits { low, high, both };

// A quantity of a check, its limits, and whether its logarithm is the normally distributed value.
struct Quantity {
  std::string_view name;
  double CameraCheck::*value;
  Limits limits;
  bool logarithmic;
};

constexpr std::array<Quantity, 4> quantities{{{"noise", &CameraCheck::noise_mm, Limits::high, true},
                                              {"measured", &CameraCheck::measured, Limits::low, false},
                                              {"drift", &CameraCheck::drifting, Limits::high, false},
                                              {"distance", &CameraCheck::distance_m, Limits::both, true}}};

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread_of(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  Spread spread;
  for (const double value : values) spread.mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / (n - 1.0));
  return spread;
}

double on_scale(const Quantity& quantity, double value) {
  constexpr double least = 1e-9;  // the noise of a camera that repeats itself exactly is 0
  return quantity.logarithmic ? std::log(std::max(least, value)) : value;
}

double from_scale(const Quantity& quantity, double value) {
  return quantity.logarithmic ? std::exp(value) : value;
}

CheckedQuantity judge(const Quantity& quantity, const CameraCheck& now, const std::vector<CameraCheck>& sound,
                      const CheckStandardOptions& options) {
  std::vector<double> values;
  for (const CameraCheck& check : sound) values.push_back(on_scale(quantity, check.*quantity.value));
  Spread spread = spread_of(values);
  // On a logarithmic scale, a share of the mean is an absolute difference.
  const double least = options.least_spread * (quantity.logarithmic ? 1.0 : std::abs(spread.mean));
  spread.deviation = std::max(spread.deviation, least);
  const double n = static_cast<double>(values.size());
  const double sides = quantity.limits == Limits::both ? 2.0 : 1.0;
  const double tail = options.false_alarm / (static_cast<double>(quantities.size()) * sides);
  const double t = boost::math::quantile(boost::math::complement(boost::math::students_t(n - 1.0), tail));
  const double reach = t * spread.deviation * std::sqrt(1.0 + 1.0 / n);
  CheckedQuantity checked{quantity.name, now.*quantity.value, {}, {}, true};
  if (quantity.limits != Limits::high) checked.low = from_scale(quantity, spread.mean - reach);
  if (quantity.limits != Limits::low) checked.high = from_scale(quantity, spread.mean + reach);
  checked.fit =
      !(checked.low && checked.value < *checked.low) && !(checked.high && checked.value > *checked.high);
  return checked;
}

}  // namespace

CameraJudgement judge(const CameraCheck& now, const std::vector<CameraCheck>& history,
                      const CheckStandardOptions& options) {
  check_options(options);
  std::vector<CameraCheck> sound;
  std::ranges::copy_if(history, std::back_inserter(sound), &CameraCheck::fit);
  CameraJudgement judgement;
  judgement.earlier = sound.size();
  judgement.known = sound.size() >= static_cast<std::size_t>(options.least_checks);
  for (const Quantity& quantity : quantities) {
    judgement.quantities.push_back(judgement.known
                                       ? judge(quantity, now, sound, options)
                                       : CheckedQuantity{quantity.name, now.*quantity.value, {}, {}, true});
  }
  judgement.fit = std::ranges::all_of(judgement.quantities, &CheckedQuantity::fit);
  return judgement;
}

std::string check_line(const CameraCheck& check) {
  Json line{{"taken_at", check.taken_at}, {"frames", check.frames},     {"noise_mm", check.noise_mm},
            {"measured", check.measured}, {"drifting", check.drifting}, {"distance_m", check.distance_m}};
  if (check.temperature_c) line["temperature_c"] = *check.temperature_c;
  line["fit"] = check.fit;
  return json_text(line);
}

std::vector<CameraCheck> parse_checks(const std::string& text, const std::string& source) {
  std::vector<CameraCheck> checks;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line) && !lines.eof(); ++number) {
    const std::string where = fmt::format("{}:{}", source, number);
    const nlohmann::json json = parse_json(line, where);
    const JsonObject object(json, where);
    CameraCheck check;
    check.taken_at = object.string("taken_at");
    check.frames = static_cast<std::size_t>(std::max(0, object.integer("frames")));
    check.noise_mm = object.number("noise_mm");
    check.measured = object.number("measured");
    check.drifting = object.number("drifting");
    check.distance_m = object.number("distance_m");
    check.temperature_c = object.optional_number("temperature_c");
    check.fit = object.boolean("fit");
    checks.push_back(check);
  }
  return checks;
}

}  // namespace rva
