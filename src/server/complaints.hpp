// A log of refused requests and connections, limited in rate.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace rva {

/// Logs the first complaint of a kind. Further ones are counted, and logged with their number when one comes
/// a minute or more after the last logged one, so that clients cannot flood the log. Complaints must not
/// contain anything that a client sent. Every member may be called from any thread.
class Complaints {
 public:
  explicit Complaints(std::function<void(const std::string& line)> log) : log_(std::move(log)) {}

  void add(const std::string& kind, double now_s);

 private:
  struct Count {
    double told_s = 0.0;
    int since = 0;
  };
  std::function<void(const std::string&)> log_;
  std::mutex mutex_;
  std::map<std::string, Count> counts_;
};

}  // namespace rva
