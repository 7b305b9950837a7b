#include "server/private_paths.hpp"

#include <regex>

namespace rva {

// The data folder's path may contain spaces, since its end is known. Other paths end at a space or at the
// punctuation that follows a path in messages. Devices keep their path, by which users know them.
std::string without_folders(const std::string& text) {
  static const std::regex in_data(R"((^|[\s"'(:])/(?:(?!: )[^\n])*?(inspections/[0-9]{6}))");
  static const std::regex elsewhere(R"((^|[\s"'(:])/(?!dev/)(?:[^\s:"'()/]+/)+([^\s:"'()/]+))");
  return std::regex_replace(std::regex_replace(text, in_data, "$1$2"), elsewhere, "$1…/$2");
}

}  // namespace rva
