#include "map/repeatability_summary.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace rva {
namespace {

/// The members of one joint.
struct Joint {
  const char* name;
  double JointTurn::*turn_deg;
  ArrivedFrom MeasuredReturn::*from;
};
constexpr Joint pan_joint{"pan", &JointTurn::pan_deg, &MeasuredReturn::pan};
constexpr Joint tilt_joint{"tilt", &JointTurn::tilt_deg, &MeasuredReturn::tilt};

Groups returns_from(ArrivedFrom side, const Joint& joint, const Repeatability& measured) {
  Groups groups;
  for (const PoseReturns& pose : measured.poses) {
    groups.emplace_back();
    for (const MeasuredReturn& back : pose.returns) {
      if (back.*joint.from == side) groups.back().push_back(back.turn.*joint.turn_deg);
    }
  }
  return groups;
}

Groups still_pictures(const Joint& joint, const Repeatability& measured) {
  Groups groups;
  for (const PoseReturns& pose : measured.poses) {
    groups.emplace_back();
    for (const JointTurn& turn : pose.still) groups.back().push_back(turn.*joint.turn_deg);
  }
  return groups;
}

JointReturns returns_of(const Joint& joint, const Repeatability& measured) {
  const Groups smaller = returns_from(ArrivedFrom::smaller, joint, measured);
  const Groups larger = returns_from(ArrivedFrom::larger, joint, measured);
  return {pooled_deviation(smaller),        largest(smaller),
          pooled_deviation(larger),         largest(larger),
          mean_difference(smaller, larger), pooled_deviation(still_pictures(joint, measured))};
}

// Play is a loss in either direction.
Estimated size_of(const Estimated& value) {
  return value.value >= 0.0 ? value : Estimated{-value.value, -value.high, -value.low};
}

Fitness fitness_of(const Estimated& value, double limit_deg) {
  if (value.high <= limit_deg) return Fitness::fit;
  return value.low > limit_deg ? Fitness::unfit : Fitness::undecided;
}

// The part of a deviation that the noise of the pictures does not explain, as far as is certain.
Estimated without_noise(const Estimated& deviation, const Estimated& noise) {
  const double low_squared = deviation.low * deviation.low - noise.high * noise.high;
  return {deviation.value, std::sqrt(std::max(0.0, low_squared)), deviation.high};
}

// A return is the difference of two pictures, each with noise.
Estimated within_noise(double off_deg, const Estimated& noise) {
  constexpr double deviations = 3.0;
  return {off_deg, std::max(0.0, off_deg - deviations * noise.value), off_deg + deviations * noise.value};
}

void judge(const Joint& joint, const JointReturns& returns, const RepeatabilityLimits& limits,
           std::vector<Criterion>& criteria) {
  const auto add = [&](const char* name, const Estimated& value, double limit_deg) {
    criteria.push_back({joint.name, name, value, limit_deg, fitness_of(value, limit_deg)});
  };
  add("deviation", without_noise(returns.deviation, returns.noise), limits.deviation_deg);
  add("most_off", within_noise(returns.most_off_deg, returns.noise), limits.off_deg);
  add("play", size_of(returns.play), limits.play_deg);
  criteria.push_back({joint.name, "noise", returns.noise, limits.noise_deg,
                      returns.noise.value <= limits.noise_deg ? Fitness::fit : Fitness::undecided});
}

Fitness verdict_of(const std::vector<Criterion>& criteria) {
  const auto any = [&](Fitness fitness) {
    return std::ranges::any_of(criteria, [&](const Criterion& each) { return each.fitness == fitness; });
  };
  if (any(Fitness::unfit)) return Fitness::unfit;
  return any(Fitness::undecided) ? Fitness::undecided : Fitness::fit;
}

}  // namespace

RepeatabilitySummary summary_of(const Repeatability& measured, const RepeatabilityLimits& limits) {
  check_options(limits);
  RepeatabilitySummary summary{returns_of(pan_joint, measured), returns_of(tilt_joint, measured)};
  for (const PoseReturns& pose : measured.poses) {
    summary.returns += pose.returns.size();
    for (const MeasuredReturn& back : pose.returns)
      summary.most_rest_deg = std::max(summary.most_rest_deg, std::abs(back.turn.rest_deg));
  }
  judge(pan_joint, summary.pan, limits, summary.criteria);
  judge(tilt_joint, summary.tilt, limits, summary.criteria);
  summary.verdict = verdict_of(summary.criteria);
  return summary;
}

}  // namespace rva
