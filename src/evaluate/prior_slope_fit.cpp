#include "evaluate/prior_slope_fit.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace rva {
namespace {

constexpr double least_prior_peaks = 0.5;
constexpr double least_slope = 0.01;
constexpr double greatest_slope = 20.0;
constexpr int bits = 20;

/// The number of an image's peaks above the onset, and the sum of their excesses over it.
struct Excesses {
  double count = 0.0;
  double sum = 0.0;
};

std::vector<Excesses> excesses_of(const std::vector<std::vector<float>>& peaks_of_images) {
  std::vector<Excesses> images;
  for (const std::vector<float>& peaks : peaks_of_images) {
    Excesses excesses;
    for (const float peak : peaks) {
      const double excess = static_cast<double>(peak) - FalseAlarmTail::onset;
      if (excess <= 0.0) continue;
      excesses.count += 1.0;
      excesses.sum += excess;
    }
    if (excesses.count > 0.0) images.push_back(excesses);
  }
  return images;
}

/// The logarithm of the likelihood as a function of the logarithms of the slope and of its weight, in peaks.
class Likelihood {
 public:
  explicit Likelihood(std::vector<Excesses> images) : images_(std::move(images)) {}

  // Equation 69 of docs/math.md.
  [[nodiscard]] double at(double log_slope, double log_peaks) const {
    const double shape = std::exp(log_peaks);
    const double rate = shape / std::exp(log_slope);
    double sum = 0.0;
    for (const Excesses& image : images_)
      sum += shape * std::log(rate) - std::lgamma(shape) + std::lgamma(shape + image.count) -
             (shape + image.count) * std::log(rate + image.sum);
    return sum;
  }

  // The position and value of the maximum over the other parameter.
  [[nodiscard]] std::pair<double, double> best_slope(double log_peaks) const {
    return greatest([&](double log_slope) { return at(log_slope, log_peaks); }, std::log(least_slope),
                    std::log(greatest_slope));
  }
  [[nodiscard]] std::pair<double, double> best_peaks(double log_slope) const {
    return greatest([&](double log_peaks) { return at(log_slope, log_peaks); }, std::log(least_prior_peaks),
                    std::log(most_prior_peaks));
  }

 private:
  [[nodiscard]] static std::pair<double, double> greatest(const auto& of, double low, double high) {
    const auto [where, least] =
        boost::math::tools::brent_find_minima([&](double value) { return -of(value); }, low, high, bits);
    return {where, -least};
  }

  std::vector<Excesses> images_;
};

// The interval in which the profile likelihood is within half of the 95 % quantile of chi-squared
// of its maximum.
Interval interval(const auto& profile, double best, double low, double high) {
  constexpr double fall = 0.5 * 3.841;
  const double least = profile(best) - fall;
  const auto crossing = [&](double end) {
    const auto above = [&](double value) { return profile(value) - least; };
    if (above(end) >= 0.0) return end;
    const auto [from, to] = boost::math::tools::bisect(above, std::min(best, end), std::max(best, end),
                                                       boost::math::tools::eps_tolerance<double>(bits));
    return 0.5 * (from + to);
  };
  return {std::exp(crossing(low)), std::exp(crossing(high))};
}

}  // namespace

PriorSlopeFit fit_prior_slope(const std::vector<std::vector<float>>& peaks_of_images) {
  std::vector<Excesses> images = excesses_of(peaks_of_images);
  if (images.empty())
    throw UsageError("images", "have no peak above the onset of a tail, so none can be fitted",
                     "give more images");
  PriorSlopeFit fit;
  fit.images = images.size();
  for (const Excesses& image : images) fit.seen += static_cast<std::size_t>(image.count);
  const Likelihood likelihood(std::move(images));
  const auto of_slope = [&](double log_slope) { return likelihood.best_peaks(log_slope).second; };
  const auto of_peaks = [&](double log_peaks) { return likelihood.best_slope(log_peaks).second; };
  const double low = std::log(least_prior_peaks);
  const double high = std::log(most_prior_peaks);
  const double log_peaks =
      boost::math::tools::brent_find_minima([&](double value) { return -of_peaks(value); }, low, high, bits)
          .first;
  const double log_slope = likelihood.best_slope(log_peaks).first;
  fit.most_probable = {std::exp(log_slope), std::exp(log_peaks)};
  fit.slope = interval(of_slope, log_slope, std::log(least_slope), std::log(greatest_slope));
  fit.peaks = interval(of_peaks, log_peaks, low, high);
  return fit;
}

}  // namespace rva
