#include "inspect/records.hpp"

namespace rva {

std::string_view name_of(PersonRole role) {
  switch (role) {
    case PersonRole::viewer:
      return "viewer";
    case PersonRole::operator_:
      return "operator";
    case PersonRole::inspector:
      return "inspector";
  }
  return "";
}

std::optional<PersonRole> role_from_name(std::string_view name) {
  for (const PersonRole role : {PersonRole::viewer, PersonRole::operator_, PersonRole::inspector}) {
    if (name == name_of(role)) return role;
  }
  return std::nullopt;
}

}  // namespace rva
