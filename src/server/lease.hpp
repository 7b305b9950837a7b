// The right to drive the robot.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace rva {

/// One client at a time has the lease, and everybody can see who. The lease ends when it has not been used
/// for a minute, or when its holder has been disconnected for ten seconds, so that a reloaded page keeps it.
/// Every member may be called from any thread. All times are of one clock that never goes back.
class Lease {
 public:
  static constexpr double idle_limit_s = 60.0;
  static constexpr double gone_limit_s = 10.0;

  /// The client that has the controls.
  struct Holder {
    std::string client;  ///< secret id of the client
    std::string name;    ///< for display
    bool operator==(const Holder&) const = default;
  };

  /// @param take_over even if another client has it
  /// @return whether `who` has it now
  bool take(const Holder& who, bool take_over, double now_s);
  void release(const std::string& client);

  /// Records that a client used the lease, which extends it.
  /// @return whether the client has it
  bool use(const std::string& client, double now_s);

  // A client may have several connections, for example when it opens a new one before the loss of the old one
  // is detected.
  void arrive(const std::string& client);
  /// @return whether this was its last connection
  bool leave(const std::string& client, double now_s);

  [[nodiscard]] std::optional<Holder> holder(double now_s) const;

 private:
  [[nodiscard]] bool is_held(double now_s) const;

  mutable std::mutex mutex_;
  std::optional<Holder> holder_;
  double used_s_ = 0.0;
  std::optional<double> gone_s_;
  std::map<std::string, int> connections_;  // their number, by client
};

}  // namespace rva
