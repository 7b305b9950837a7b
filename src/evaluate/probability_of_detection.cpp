#include "evaluate/probability_of_detection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>
#include <vector>

namespace rva {
namespace {

constexpr double steepest = 60.0;  // logits per factor of e: from 10 % to 90 % within 8 % of size
constexpr double logit_of_nine_tenths = 2.1972245773362196;  // ln 9

/// The likelihood of logistic curves, parametrised by their slope and the size `a90` at which their
/// probability is 90 %.
class HitLikelihood {
 public:
  explicit HitLikelihood(std::span<const DetectionTrial> trials) {
    for (const DetectionTrial& trial : trials) {
      ln_sizes_.push_back(std::log(trial.size_mm));
      signs_.push_back(trial.found ? -1.0 : 1.0);
    }
  }

  /// The logarithm of the likelihood, penalised by the square root of the information matrix's determinant
  /// (Firth 1993). Without the penalty, curves from few trials are too steep, and the coverage of the bounds
  /// is lower than stated.
  /// Equations 72 and 73 of docs/math.md.
  [[nodiscard]] double log_of(double ln_a90, double slope) const {
    double sum = 0.0;
    double information = 0.0;  // information matrix of the logit at a90 and of the slope
    double of_slope = 0.0;
    double of_both = 0.0;
    for (std::size_t i = 0; i < signs_.size(); ++i) {
      const double from_a90 = ln_sizes_[i] - ln_a90;
      const double odds_against = std::exp(signs_[i] * (logit_of_nine_tenths + slope * from_a90));
      sum -= std::log1p(odds_against);
      const double variance = odds_against / ((1.0 + odds_against) * (1.0 + odds_against));
      information += variance;
      of_both += variance * from_a90;
      of_slope += variance * from_a90 * from_a90;
    }
    return sum + 0.5 * std::log(std::max(information * of_slope - of_both * of_both, least_determinant));
  }

  /// The most likely slope that is not negative, by golden section: the logarithm is concave in the slope.
  [[nodiscard]] double best_slope(double ln_a90) const {
    constexpr double golden = 1.0 / std::numbers::phi;
    constexpr double precise = 1e-2;
    double low = 0.0;
    double high = steepest;
    while (high - low > precise) {
      const double left = high - golden * (high - low);
      const double right = low + golden * (high - low);
      if (log_of(ln_a90, left) < log_of(ln_a90, right))
        low = left;
      else
        high = right;
    }
    return 0.5 * (low + high);
  }

  [[nodiscard]] double log_at_best(double ln_a90) const { return log_of(ln_a90, best_slope(ln_a90)); }

 private:
  static constexpr double least_determinant = 1e-12;

  std::vector<double> ln_sizes_;
  std::vector<double> signs_;
};

/// The profile likelihood over sizes a90, evenly spaced in their logarithm.
struct Profile {
  std::vector<double> ln_a90;
  std::vector<double> log_likelihood;

  Profile(const HitLikelihood& likelihood, double least_mm, double most_mm) {
    constexpr int steps = 400;
    for (int i = 0; i <= steps; ++i) {
      ln_a90.push_back(std::lerp(std::log(least_mm), std::log(most_mm), static_cast<double>(i) / steps));
      log_likelihood.push_back(likelihood.log_at_best(ln_a90.back()));
    }
  }
  [[nodiscard]] std::size_t best() const {
    return static_cast<std::size_t>(std::ranges::max_element(log_likelihood) - log_likelihood.begin());
  }
};

// The smallest size such that it and all larger ones are rejected by the likelihood ratio test;
// empty if none.
// Equation 74 of docs/math.md.
std::optional<double> upper_bound_mm(const Profile& profile) {
  constexpr double quantile_90_of_chi_squared = 2.705543454095404;  // one-sided: 95 %
  const double least = profile.log_likelihood[profile.best()] - 0.5 * quantile_90_of_chi_squared;
  std::size_t bound = profile.ln_a90.size();
  while (bound > 0 && profile.log_likelihood[bound - 1] < least) --bound;
  if (bound == profile.ln_a90.size()) return std::nullopt;
  return std::exp(profile.ln_a90[bound]);
}

}  // namespace

std::optional<DetectionSizes> fit_detection_sizes(std::span<const DetectionTrial> trials) {
  if (trials.empty()) return std::nullopt;
  constexpr double beyond = 3.0;
  const auto [smallest, largest] =
      std::ranges::minmax(trials | std::views::transform(&DetectionTrial::size_mm));
  if (smallest >= largest) return std::nullopt;
  const double least_mm = smallest / beyond;
  const HitLikelihood likelihood(trials);
  const Profile profile(likelihood, least_mm, largest * beyond);
  const std::size_t best = profile.best();
  const double ln_a90 = profile.ln_a90[best];
  const double slope = likelihood.best_slope(ln_a90);
  const double a50_mm = std::exp(ln_a90 - logit_of_nine_tenths / slope);
  if (best == 0 || best + 1 == profile.ln_a90.size() || a50_mm < least_mm) return std::nullopt;
  return DetectionSizes{a50_mm, std::exp(ln_a90), upper_bound_mm(profile)};
}

}  // namespace rva
