// Whether an inspection can begin, and if not, why.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "camera/live_camera.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "robot/drive.hpp"

namespace rva {

/// Options of the check before a capture.
struct ReadinessOptions {
  int frames = 30;
  double least_rate_hz = 2.0;
  double least_measured = 0.4;
  double most_drift_px = 0.02;
  double least_free_gb = 2.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames,
          OptionField{"readiness-frames", "", 8, 1000, "frames that the check before a capture examines"});
    visit(self.least_rate_hz,
          OptionField{"least-rate", "hz", 0, 1000, "a camera with fewer frames a second is not ready"});
    visit(self.least_measured,
          OptionField{"least-measured", "", 0, 1, "least share of the depth image with a measurement"});
    visit(self.most_drift_px,
          OptionField{"most-drift", "px", 0, 10,
                      "a camera whose disparities move by more during the check is not warm"});
    visit(self.least_free_gb,
          OptionField{"least-free", "gb", 0, 1e6, "space that must be free where captures are kept"});
  }
};

/// One aspect of the check before a capture.
struct ReadinessItem {
  std::string name;  ///< "Camera", "Depth", "Warm-up", "Robot", "Disk"
  bool ready = false;
  std::string says;  ///< sentences for the user: what was measured and, if it is not enough, what to do
  /// The same for programs that state it in their own words, such as "disk-full". Names are added, never
  /// changed.
  std::string code;
  /// What was measured, by names that end in the unit, such as "free_gb"; shares are from 0 to 1.
  std::map<std::string, double> values{};
};

/// The result of the check before a capture.
struct Readiness {
  std::vector<ReadinessItem> items;
  std::string checked_at;  ///< ISO 8601
  [[nodiscard]] bool ready() const;
};

/// Checks the camera over `options.frames` frames, the robot, and the disk of `folder`. A failure is an item
/// that is not ready, not an exception.
/// @param drive null if there is no robot
/// @throws Interrupted when `progress` does
[[nodiscard]] Readiness check_readiness(LiveCamera& camera, const Drive* drive,
                                        const std::filesystem::path& folder, const ReadinessOptions& options,
                                        const Progress& progress);

}  // namespace rva
