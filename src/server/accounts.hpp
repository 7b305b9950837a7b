// The people who may sign in, and what each may do.
#pragma once

#include <string>
#include <vector>

#include "core/enum_names.hpp"

namespace rva {

/// Roles of people. Each may also do everything that the roles before it may.
enum class PersonRole {
  viewer,     ///< view, measure, stop the robot
  operator_,  ///< drive, begin inspections, take captures, leave out regions
  inspector,  ///< decide on findings
};
template <>
inline constexpr auto enum_names<PersonRole> = std::to_array<EnumName<PersonRole>>({
    {PersonRole::viewer, "viewer"},
    {PersonRole::operator_, "operator"},
    {PersonRole::inspector, "inspector"},
});

/// A person's account as it is recorded.
struct Account {
  std::string name;
  PersonRole role = PersonRole::viewer;
  std::string password_hash;  ///< made by hash_password() (password.hpp)
  /// Changes whenever the account is added or changed: a sign-in belongs to the generation, not to the name.
  /// Set by Accounts, not by the caller.
  std::string generation{};
};

/// Persistent accounts. Every change is either complete and on the disk when the call returns, or has not
/// happened. Every member may be called from any thread, and throws Error when the disk or the database
/// fails.
class Accounts {
 public:
  Accounts() = default;
  virtual ~Accounts() = default;
  Accounts(const Accounts&) = delete;
  Accounts& operator=(const Accounts&) = delete;

  /// Adds an account, or replaces the one with the same name.
  virtual void set_account(const Account& account) = 0;
  [[nodiscard]] virtual std::vector<Account> accounts() const = 0;
  /// @return whether the account existed
  virtual bool remove_account(const std::string& name) = 0;
};

}  // namespace rva
