// The lines of docs/protocol.md that both sides of it are tested with.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace rva::test {

/// @param direction "host" or "robot": the sender of the lines
/// @return without their ends
inline std::vector<std::string> golden_lines(const std::string& direction) {
  std::ifstream file(RVA_GOLDEN_LINES);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(direction + " ")) lines.push_back(line.substr(direction.size() + 1));
  }
  return lines;
}

}  // namespace rva::test
