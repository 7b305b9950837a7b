// Sign-ins of people with accounts.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "server/accounts.hpp"

namespace rva {

/// The person who makes a request.
struct Person {
  std::string name;  ///< of the account; empty if there are no accounts
  PersonRole role = PersonRole::viewer;
};

/// Sign-ins are kept in memory, so a restart ends them. They expire after twelve hours, the length of a
/// shift. From one address, five wrong passwords for a name block that name, and thirty for any names block
/// all names, for a minute after the last of them. A client that guesses passwords therefore locks out nobody
/// else, until a hundred wrong passwords from all addresses block the name everywhere. Every member may be
/// called from any thread. All times are of one clock that never goes back.
class Sessions {
 public:
  static constexpr double lifetime_s = 12.0 * 3600.0;
  static constexpr int most_failures_of_name = 5;
  static constexpr int most_failures_from = 30;
  static constexpr int most_failures_of_name_from_all = 100;
  static constexpr double pause_s = 60.0;

  explicit Sessions(const Accounts& accounts) : accounts_(accounts) {}

  /// Why a sign-in succeeded or failed.
  enum class Answer { signed_in, wrong, too_many };
  /// The result of an attempt to sign in.
  struct SignIn {
    Answer answer = Answer::wrong;
    std::string token;  ///< only if signed in
  };
  /// Takes a tenth of a second, whether the name is known or not.
  /// @param from address of the client
  [[nodiscard]] SignIn sign_in(const std::string& name, const std::string& password, const std::string& from,
                               double now_s);
  void sign_out(const std::string& token);

  /// The result of confirm().
  struct Confirmation {
    Answer answer = Answer::wrong;
    PersonRole role = PersonRole::viewer;  ///< of the account, if the answer is signed_in
  };
  /// Verifies name and password, as sign_in() does and with the same limits, without a sign-in.
  [[nodiscard]] Confirmation confirm(const std::string& name, const std::string& password,
                                     const std::string& from, double now_s);

  /// The person who signed in with a token; empty if the token is unknown or has expired, or if the account
  /// was removed or changed since the sign-in.
  [[nodiscard]] std::optional<Person> person(const std::string& token, double now_s) const;

  /// Whether people must sign in: true from the first account on. While the program runs, it stays true when
  /// the last account is removed, which locks everybody out rather than letting everybody in.
  [[nodiscard]] bool needed() const {
    if (!needed_ && !accounts_.accounts().empty()) needed_ = true;
    return needed_;
  }

 private:
  struct Failures {
    int count = 0;
    double last_s = 0.0;
  };
  /// By name and address; an empty name or address stands for all of them.
  using FailuresOf = std::map<std::pair<std::string, std::string>, Failures>;
  struct Session {
    std::string name;
    std::string generation;  // of the account
    double since_s = 0.0;
  };

  [[nodiscard]] std::pair<Answer, Account> verified(const std::string& name, const std::string& password,
                                                    const std::string& from, double now_s);
  [[nodiscard]] bool too_many(const std::string& name, const std::string& from, double now_s);
  [[nodiscard]] std::optional<Account> account(const std::string& name) const;

  const Accounts& accounts_;
  mutable std::atomic<bool> needed_ = false;
  mutable std::mutex mutex_;                 // guards all below
  std::map<std::string, Session> sessions_;  // by token
  FailuresOf failures_;
};

}  // namespace rva
