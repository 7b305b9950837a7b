// What `rva doctor` found, and what to do about it.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/error.hpp"
#include "core/options.hpp"

namespace rva {

/// The result of one check.
enum class CheckState {
  ok,
  warning,    ///< it works, but not as well as it should
  failed,     ///< it does not work
  not_tried,  ///< it does not apply, or an earlier check failed
};
/// The names that JSON and the printed list use.
template <>
inline constexpr auto enum_names<CheckState> = std::to_array<EnumName<CheckState>>({
    {CheckState::ok, "ok"},
    {CheckState::warning, "warning"},
    {CheckState::failed, "failed"},
    {CheckState::not_tried, "not-tried"},
});

/// One check.
struct CheckedItem {
  std::string name;                     ///< such as "frame-rate". Names are added, never changed
  CheckState state = CheckState::ok;    ///< how it ended
  std::string result;                   ///< one line: what was found, or why it was not tried
  std::string advice;                   ///< one line: what to do; empty if nothing is to be done
  std::map<std::string, double> values; /**< what was measured, by names that end in the unit; shares are from
                                             0 to 1 */
};

/// All checks of a part, in the order in which they were made.
using CheckedItems = std::vector<CheckedItem>;

/// Everything that was checked.
struct Checkup {
  CheckedItems computer;  ///< examine_computer()
  CheckedItems camera;    ///< examine_camera()
  CheckedItems robot;     ///< examine_robot()
};

/// Options of the checks.
struct DoctorOptions {
  int frames = 60;              ///< frames that the camera's checks examine
  double least_measured = 0.4;  ///< least share of the depth image with a measurement
  double most_noise_px = 0.2;   ///< most noise of disparity
  double least_free_gb = 2.0;   ///< least free space where captures are kept

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 8, 1000, "frames that the camera's checks examine"});
    visit(self.least_measured, OptionField{"least-measured", "", 0, 1,
                                           "a smaller share of the depth image with a measurement fails"});
    visit(self.most_noise_px, OptionField{"most-noise", "px", 0.001, 10,
                                          "more noise of disparity fails; half of it is a warning"});
    visit(self.least_free_gb,
          OptionField{"least-free", "gb", 0, 1e6, "less free space fails; ten times as much is a warning"});
  }
};

/// A check without a complaint.
[[nodiscard]] CheckedItem passed(std::string name, std::string result);
/// A check that did not apply. @param reason one line
[[nodiscard]] CheckedItem not_tried(std::string name, std::string reason);
/// The same for several checks.
[[nodiscard]] CheckedItems none_tried(const std::vector<std::string>& names, const std::string& reason);
/// A check that failed with an error, whose remedy is the advice.
[[nodiscard]] CheckedItem failed(std::string name, const Error& error);

/// The worst state of all checks that were tried: failed, then warning, then ok.
[[nodiscard]] CheckState worst(const Checkup& checkup);

/// An array of all checks, each with `part` ("computer", "camera", "robot"), `name`, `state`, `result`, and,
/// where there are some, `advice` and `values`.
[[nodiscard]] nlohmann::ordered_json json_of(const Checkup& checkup);

}  // namespace rva
