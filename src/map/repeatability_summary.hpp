// What a measurement of a robot's returns amounts to, and whether the robot is fit for inspections.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/options.hpp"
#include "map/repeatability.hpp"
#include "map/return_statistics.hpp"

namespace rva {

/// Limits that a robot must keep to be fit for inspections. docs/robot.md derives them.
struct RepeatabilityLimits {
  double deviation_deg = 0.16;  ///< half a servo step
  double off_deg = 0.35;        ///< a servo step, and a little more
  double play_deg = 0.6;        ///< less than the run-up of approach(), by a step
  double noise_deg = 0.01;      ///< of the measurement itself

  static void describe(auto&& self, auto&& visit) {
    visit(self.deviation_deg, OptionField{"most-deviation", "deg", 0.001, 10,
                                          "limit of the standard deviation of returns from smaller angles"});
    visit(self.off_deg, OptionField{"most-off", "deg", 0.001, 10,
                                    "limit of the distance of such a return from the first arrival"});
    visit(self.play_deg, OptionField{"most-play", "deg", 0.001, 10,
                                     "limit of the difference between returns from either side"});
    visit(self.noise_deg, OptionField{"most-noise", "deg", 0.0001, 10,
                                      "limit of the standard deviation of pictures without a motion"});
  }
};

/// The returns of one joint to all poses.
struct JointReturns {
  Estimated deviation;               ///< of returns from smaller angles, deg
  double most_off_deg = 0.0;         ///< of them, from the first arrival
  Estimated deviation_larger;        ///< of returns from larger angles, deg
  double most_off_larger_deg = 0.0;  ///< of them, from the first arrival
  Estimated play;   ///< by how much larger the camera rests after returns from larger angles, deg
  Estimated noise;  ///< standard deviation of pictures without a motion, deg
};

/// Whether something keeps a limit.
enum class Fitness {
  fit,
  unfit,
  undecided,  ///< the limit is within the interval, or the measurement is too noisy
};
/// The names in JSON.
template <>
inline constexpr auto enum_names<Fitness> = std::to_array<EnumName<Fitness>>({
    {Fitness::fit, "fit"},
    {Fitness::unfit, "unfit"},
    {Fitness::undecided, "undecided"},
});

/// One value and its limit.
struct Criterion {
  std::string joint;                     ///< "pan", "tilt"
  std::string name;                      ///< as in JSON: "deviation", "most_off", "play", "noise"
  Estimated value;                       ///< deg; the interval allows for the noise of the pictures
  double limit_deg = 0.0;                ///< the most that is fit
  Fitness fitness = Fitness::undecided;  ///< of this value
};

/// What a measurement amounts to.
struct RepeatabilitySummary {
  JointReturns pan;                      ///< of the first joint
  JointReturns tilt;                     ///< of the second joint
  double most_rest_deg = 0.0;            ///< largest turn that the joints cannot cause
  std::size_t returns = 0;               ///< to all poses
  std::vector<Criterion> criteria{};     ///< of pan, then of tilt
  Fitness verdict = Fitness::undecided;  ///< unfit if any criterion is, else undecided if any is
};

/// @throws UsageError when a limit is out of range
[[nodiscard]] RepeatabilitySummary summary_of(const Repeatability& measured,
                                              const RepeatabilityLimits& limits);

}  // namespace rva
