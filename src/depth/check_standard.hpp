// A camera against its own history: the check standard of measurement laboratories (NIST/SEMATECH e-Handbook
// of Statistical Methods, chapter 2.2.2), with a scene that stays as the artefact.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/options.hpp"
#include "depth/noise.hpp"

namespace rva {

struct CheckStandardOptions {
  int least_checks = 5;
  double false_alarm = 0.01;
  double least_spread = 0.02;

  static void describe(auto&& self, auto&& visit) {
    visit(self.least_checks, OptionField{"least-checks", "", 3, 1000,
                                         "earlier checks that a camera is judged by; fewer say nothing"});
    visit(self.false_alarm,
          OptionField{"false-alarm", "", 1e-6, 0.2, "share of sound cameras that a check calls unfit"});
    visit(self.least_spread,
          OptionField{"least-spread", "", 0, 1,
                      "standard deviation between checks, as a share of their mean, that is "
                      "taken for granted however alike they were"});
  }
};

/// What one check measured.
struct CameraCheck {
  std::string taken_at;  ///< ISO 8601
  std::size_t frames = 0;
  double noise_mm = 0.0;    ///< median over pixels of the standard deviation over time
  double measured = 0.0;    ///< share of pixels that hold a measurement
  double drifting = 0.0;    ///< share of pixels whose first and last frames differ (Welch's test)
  double distance_m = 0.0;  ///< median over pixels: the scene stays, so this stays
  std::optional<double> temperature_c;
  bool fit = true;  ///< as it was judged then; what was not fit is no standard for later ones
};

/// One quantity against the earlier ones.
struct CheckedQuantity {
  std::string_view name;  ///< "noise", "measured", "drift", "distance"
  double value = 0.0;
  std::optional<double> low;  ///< limits of a sound camera; empty where there is no such limit, or no history
  std::optional<double> high;
  bool fit = true;
};

struct CameraJudgement {
  std::size_t earlier = 0;  ///< fit checks before
  bool known = false;       ///< there were enough of them
  bool fit = true;          ///< true also where nothing is known
  std::vector<CheckedQuantity> quantities;
};

/// The prediction interval for one more value of a normal quantity, mean and deviation learnt from n earlier
/// ones: mean +- t(n-1) s sqrt(1 + 1/n), with the false alarms shared among the quantities. Noise and drift
/// are judged upwards only, the measured share downwards only. Noise is judged by its logarithm.
/// @param history earlier checks, oldest first; those that were not fit are left out
/// @throws UsageError when an option is out of range
[[nodiscard]] CameraJudgement judge(const CameraCheck& now, const std::vector<CameraCheck>& history,
                                    const CheckStandardOptions& options = {});

/// One line of a history, without its end; parse_check() reads it back.
[[nodiscard]] std::string check_line(const CameraCheck& check);
/// A last line without an end is left out. @throws Error naming the line that is malformed
[[nodiscard]] std::vector<CameraCheck> parse_checks(const std::string& text, const std::string& place);

}  // namespace rva
