#include "inspect/records.hpp"

namespace rva {

std::string_view name_of(Role role) {
  switch (role) {
    case Role::viewer:
      return "viewer";
    case Role::operator_:
      return "operator";
    case Role::inspector:
      return "inspector";
  }
  return "";
}

std::optional<Role> role_from_name(std::string_view name) {
  for (const Role role : {Role::viewer, Role::operator_, Role::inspector}) {
    if (name == name_of(role)) return role;
  }
  return std::nullopt;
}

}  // namespace rva
