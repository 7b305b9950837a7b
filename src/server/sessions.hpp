// Who is signed in.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "inspect/records.hpp"

namespace rva {

/// Somebody who asks.
struct Person {
  std::string name;  ///< of the account; empty where nobody needs to sign in
  PersonRole role = PersonRole::viewer;
};

/// Sign-ins are kept in memory: a restart ends them. They end after twelve hours, a shift. From one place,
/// five wrong passwords for a name, or thirty for all, close the door to that place for a minute; so whoever
/// guesses locks nobody else out, until a hundred from many places close it for that name. Every member may
/// be called from any thread; times are of one clock that does not go back.
class Sessions {
 public:
  static constexpr double lifetime_s = 12.0 * 3600.0;
  static constexpr int most_failures_of_name = 5;
  static constexpr int most_failures_from = 30;
  static constexpr int most_failures_of_name_from_all = 100;
  static constexpr double pause_s = 60.0;

  explicit Sessions(const Records& records) : records_(records) {}

  enum class Answer { signed_in, wrong, too_many };
  struct SignIn {
    Answer answer = Answer::wrong;
    std::string token;  ///< where signed in
  };
  /// Takes a tenth of a second, whether the name is known or not.
  /// @param from where the request comes from: an address
  [[nodiscard]] SignIn sign_in(const std::string& name, const std::string& password, const std::string& from,
                               double now_s);
  void sign_out(const std::string& token);

  /// Empty where the token is unknown or old, or the account was removed or changed since the sign-in.
  [[nodiscard]] std::optional<Person> person(const std::string& token, double now_s) const;

  /// Where there is no account nobody can sign in, and nobody needs to. Where there was one once, it stays
  /// so: who removes the last account opens the door to nobody, not to everybody.
  [[nodiscard]] bool needed() const {
    if (!needed_ && !records_.accounts().empty()) needed_ = true;
    return needed_;
  }

 private:
  struct Failures {
    int count = 0;
    double last_s = 0.0;
  };
  /// By name and place; with one of them empty, of all names or of all places.
  using FailuresOf = std::map<std::pair<std::string, std::string>, Failures>;
  struct Session {
    std::string name;
    std::string generation;  // of the account
    double since_s = 0.0;
  };

  [[nodiscard]] bool too_many(const std::string& name, const std::string& from, double now_s);
  [[nodiscard]] std::optional<Account> account(const std::string& name) const;

  const Records& records_;
  mutable std::atomic<bool> needed_ = false;
  mutable std::mutex mutex_;                 // guards all below
  std::map<std::string, Session> sessions_;  // by token
  FailuresOf failures_;
};

}  // namespace rva
