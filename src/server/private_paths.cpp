#include "server/private_paths.hpp"

#include <regex>

namespace rva {

// The data folder's path may have blanks; its end is known. Other paths end at a blank, and at the marks that
// follow a path in messages. Devices keep theirs: it is the name under which people know them.
std::string without_folders(const std::string& text) {
  static const std::regex in_data(R"((^|[\s"'(:])/(?:(?!: )[^\n])*?(inspections/[0-9]{6}))");
  static const std::regex elsewhere(R"((^|[\s"'(:])/(?!dev/)(?:[^\s:"'()/]+/)+([^\s:"'()/]+))");
  return std::regex_replace(std::regex_replace(text, in_data, "$1$2"), elsewhere, "$1…/$2");
}

}  // namespace rva
