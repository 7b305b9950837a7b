#include <cmath>
#include <vector>

#include "capture/formats.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto entries = rva::load_or_refuse([&] { return rva::parse_tum_list(text, "depth.txt"); });
  const auto pairs = rva::load_or_refuse([&] { return rva::parse_associations(text, "associations.txt"); });
  for (const rva::TumPair& pair : pairs.value_or(std::vector<rva::TumPair>{})) {
    rva::require(std::isfinite(pair.depth.time_s) && std::isfinite(pair.color.time_s), "a time is a number");
    rva::require(!pair.depth.file.empty() && !pair.color.file.empty(), "a file has a name");
  }
  if (!entries) return 0;
  for (const rva::TumEntry& entry : *entries) {
    rva::require(std::isfinite(entry.time_s), "a time is a number");
    rva::require(!entry.file.empty(), "a file has a name");
  }
  return 0;
}
