#include "server/sessions.hpp"

#include <algorithm>

#include "server/password.hpp"

namespace rva {

std::optional<Account> Sessions::account(const std::string& name) const {
  for (const Account& account : records_.accounts()) {
    if (account.name == name) return account;
  }
  return std::nullopt;
}

bool Sessions::too_many(const std::string& name, double now_s) {
  const auto is_old = [&](const Failures& failures) { return now_s - failures.last_s >= pause_s; };
  const std::lock_guard lock(mutex_);
  std::erase_if(failures_, [&](const auto& entry) { return is_old(entry.second); });
  if (is_old(all_failures_)) all_failures_ = {};
  const auto found = failures_.find(name);
  return all_failures_.count >= most_failures ||
         (found != failures_.end() && found->second.count >= most_failures_of_name);
}

Sessions::SignIn Sessions::sign_in(const std::string& name, const std::string& password, double now_s) {
  if (too_many(name, now_s)) return {Answer::too_many, {}};
  // Of a password that nobody has, so that the time it takes does not tell whether there is such a name.
  static const std::string nobody = hash_password(random_token());
  const std::optional<Account> known = account(name);
  const bool right = is_password(password, known ? known->password_hash : nobody);
  const std::lock_guard lock(mutex_);
  if (!known || !right) {
    Failures& failures = failures_[name];
    failures = {failures.count + 1, now_s};
    all_failures_ = {all_failures_.count + 1, now_s};
    return {Answer::wrong, {}};
  }
  failures_.erase(name);
  std::erase_if(sessions_, [&](const auto& entry) { return now_s - entry.second.since_s >= lifetime_s; });
  std::string token = random_token();
  sessions_[token] = {name, now_s};
  return {Answer::signed_in, std::move(token)};
}

void Sessions::sign_out(const std::string& token) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(token);
}

std::optional<Person> Sessions::person(const std::string& token, double now_s) const {
  std::string name;
  {
    const std::lock_guard lock(mutex_);
    const auto found = sessions_.find(token);
    if (found == sessions_.end() || now_s - found->second.since_s >= lifetime_s) return std::nullopt;
    name = found->second.name;
  }
  const std::optional<Account> known = account(name);
  return known ? std::optional(Person{known->name, known->role}) : std::nullopt;
}

}  // namespace rva
