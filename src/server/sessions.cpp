#include "server/sessions.hpp"

#include <algorithm>

#include "server/password.hpp"

namespace rva {

std::optional<Account> Sessions::account(const std::string& name) const {
  for (const Account& account : accounts_.accounts()) {
    if (account.name == name) return account;
  }
  return std::nullopt;
}

bool Sessions::too_many(const std::string& name, const std::string& from, double now_s) {
  const std::lock_guard lock(mutex_);
  std::erase_if(failures_, [&](const auto& entry) { return now_s - entry.second.last_s >= pause_s; });
  const auto reached = [&](const std::string& of, const std::string& at, int most) {
    const auto found = failures_.find({of, at});
    return found != failures_.end() && found->second.count >= most;
  };
  return reached(name, from, most_failures_of_name) || reached("", from, most_failures_from) ||
         reached(name, "", most_failures_of_name_from_all);
}

// The account is empty unless the answer is signed_in.
std::pair<Sessions::Answer, Account> Sessions::verified(const std::string& name, const std::string& password,
                                                        const std::string& from, double now_s) {
  if (too_many(name, from, now_s)) return {Answer::too_many, {}};
  // The hash of a password that nobody has, so that the time of the check does not reveal whether the name
  // exists.
  static const std::string nobody = hash_password(random_token());
  const std::optional<Account> known = account(name);
  const bool right = is_password(password, known ? known->password_hash : nobody);
  const std::lock_guard lock(mutex_);
  if (!known || !right) {
    for (const auto& [of, at] : {std::pair{name, from}, {std::string(), from}, {name, std::string()}}) {
      Failures& failures = failures_[{of, at}];
      failures = {failures.count + 1, now_s};
    }
    return {Answer::wrong, {}};
  }
  failures_.erase({name, from});
  return {Answer::signed_in, *known};
}

Sessions::Confirmation Sessions::confirm(const std::string& name, const std::string& password,
                                         const std::string& from, double now_s) {
  const auto [answer, account] = verified(name, password, from, now_s);
  return {answer, account.role};
}

Sessions::SignIn Sessions::sign_in(const std::string& name, const std::string& password,
                                   const std::string& from, double now_s) {
  const auto [answer, account] = verified(name, password, from, now_s);
  if (answer != Answer::signed_in) return {answer, {}};
  const std::lock_guard lock(mutex_);
  std::erase_if(sessions_, [&](const auto& entry) { return now_s - entry.second.since_s >= lifetime_s; });
  std::string token = random_token();
  sessions_[token] = {name, account.generation, now_s};
  return {Answer::signed_in, std::move(token)};
}

void Sessions::sign_out(const std::string& token) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(token);
}

std::optional<Person> Sessions::person(const std::string& token, double now_s) const {
  Session session;
  {
    const std::lock_guard lock(mutex_);
    const auto found = sessions_.find(token);
    if (found == sessions_.end() || now_s - found->second.since_s >= lifetime_s) return std::nullopt;
    session = found->second;
  }
  const std::optional<Account> known = account(session.name);
  if (!known || known->generation != session.generation) return std::nullopt;
  return Person{known->name, known->role};
}

}  // namespace rva
