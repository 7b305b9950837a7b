// Who drives.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace rva {

/// One client at a time holds it, and all can see who. Who does nothing with it for a minute loses it, and
/// so does who has been gone for ten seconds; until then a page that is loaded again finds it as it was.
/// Every member may be called from any thread; times are of one clock that does not go back.
class Lease {
 public:
  static constexpr double idle_limit_s = 60.0;
  static constexpr double gone_limit_s = 10.0;

  struct Holder {
    std::string client;  ///< nobody else knows it
    std::string name;    ///< for people
    bool operator==(const Holder&) const = default;
  };

  /// @param take_over from whoever holds it
  /// @return whether it is theirs now
  bool take(const Holder& who, bool take_over, double now_s);
  void release(const std::string& client);

  /// The holder did something.
  /// @return whether it is theirs
  bool use(const std::string& client, double now_s);

  // A client may have several connections, as when it opens a new one before the old one is known to be dead.
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
  std::map<std::string, int> connections_;  // of clients
};

}  // namespace rva
