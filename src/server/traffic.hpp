// What the server counts while it runs.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "core/clock.hpp"
#include "server/duration_histogram.hpp"

namespace rva {

/// Durations of one quantity, by the value of its label.
using DurationsByLabel = std::map<std::string, DurationHistogram>;

/// Every member may be called from any thread.
class Traffic {
 public:
  /// Counts of one moment.
  struct Counts {
    DurationsByLabel requests;  ///< from a complete request to its answer, by HTTP status
    DurationsByLabel pictures;  ///< from the delivery of a frame to its encoded picture, by stream
    std::size_t consoles = 0;   ///< that are connected
    double uptime_s = 0.0;      ///< since the object was constructed
  };

  /// Counts an answered request.
  void add_request(int status, double duration_s) {
    add(counts_.requests, std::to_string(status), duration_s);
  }
  /// Counts an encoded picture.
  void add_picture(const std::string& stream, double duration_s) {
    add(counts_.pictures, stream, duration_s);
  }
  /// Sets the number of connected consoles.
  void set_consoles(std::size_t consoles) {
    const std::lock_guard lock(mutex_);
    counts_.consoles = consoles;
  }
  /// The counts so far.
  [[nodiscard]] Counts counts() const {
    const std::lock_guard lock(mutex_);
    Counts counts = counts_;
    counts.uptime_s = steady_clock().now_s() - started_s_;
    return counts;
  }

 private:
  void add(DurationsByLabel& durations, const std::string& label, double duration_s) {
    const std::lock_guard lock(mutex_);
    durations[label].add(duration_s);
  }

  double started_s_ = steady_clock().now_s();
  mutable std::mutex mutex_;  // guards the counts
  Counts counts_;
};

}  // namespace rva
