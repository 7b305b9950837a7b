// Compares a camera with its own history: the check standard of measurement laboratories (NIST/SEMATECH
// e-Handbook of Statistical Methods, chapter 2.2.2), with an unchanging scene as the artefact.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera/noise.hpp"
#include "core/options.hpp"

namespace rva {

/// Options of the comparison of a camera with its own history.
struct CheckStandardOptions {
  int least_checks = 5;        ///< number of earlier checks below which a camera is not judged
  double false_alarm = 0.01;   ///< share of sound cameras that a check calls unfit
  double least_spread = 0.02;  ///< least standard deviation between checks, as a share of their mean

  static void describe(auto&& self, auto&& visit) {
    visit(self.least_checks,
          OptionField{"least-checks", "", 3, 1000,
                      "earlier checks that a camera is judged by; with fewer it is not judged"});
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
  std::string taken_at;     ///< ISO 8601
  std::size_t frames = 0;   ///< number of frames that were measured
  double noise_mm = 0.0;    ///< median over pixels of the standard deviation over time
  double measured = 0.0;    ///< share of pixels that have a measurement
  double drifting = 0.0;    ///< share of pixels whose first and last frames differ (Welch's test)
  double distance_m = 0.0;  ///< median over pixels, which does not change as long as the scene does not
  std::optional<double> temperature_c;  ///< of the camera; empty where it states none
  bool fit = true;  ///< as judged at the time; later checks are not compared with unfit ones
};

/// One quantity of a check, compared with earlier checks.
struct CheckedQuantity {
  std::string_view name;       ///< "noise", "measured", "drift", "distance"
  double value = 0.0;          ///< as measured, in the unit of the field of CameraCheck
  std::optional<double> low;   ///< limits for a sound camera; empty for no limit, or too little history
  std::optional<double> high;  ///< likewise
  bool fit = true;             ///< whether the value is within the limits; true where there are none
};

/// A camera compared with its own earlier checks.
struct CameraJudgement {
  std::size_t earlier = 0;                  ///< number of earlier checks that were fit
  bool known = false;                       ///< whether there were enough of them to judge by
  bool fit = true;                          ///< true also when `known` is false
  std::vector<CheckedQuantity> quantities;  ///< one each for noise, measured share, drift and distance
};

/// Judges each quantity by the prediction interval for one more value of a normal distribution whose mean and
/// standard deviation s are estimated from n earlier values: mean +- t(n-1) s sqrt(1 + 1/n), with the false
/// alarm rate divided among the quantities. Noise and drift have an upper limit only, the measured share a
/// lower limit only. Noise and distance are judged by their logarithms.
/// @param history earlier checks, oldest first; those that were not fit are left out
/// @throws UsageError when an option is out of range
[[nodiscard]] CameraJudgement judge(const CameraCheck& now, const std::vector<CameraCheck>& history,
                                    const CheckStandardOptions& options = {});

/// One line of a history, without a line end; parse_checks() reads it back.
[[nodiscard]] std::string check_line(const CameraCheck& check);
/// Parses a history. A last line without a line end is left out. @throws Error naming a malformed line
[[nodiscard]] std::vector<CameraCheck> parse_checks(const std::string& text, const std::string& source);

}  // namespace rva
