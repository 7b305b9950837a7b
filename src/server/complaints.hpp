// What the server has to say of its visitors: each kind once, then how often.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace rva {

/// Passes on the first complaint of a kind, and then, a minute later, how many more there were. So nobody
/// fills a log from outside. Complaints hold nothing that a visitor sent. Any thread.
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
