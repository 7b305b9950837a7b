#include <cmath>

#include "capture/formats.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto entries = rva::load_or_refuse([&] { return rva::parse_tum_list(text, "depth.txt"); });
  if (!entries) return 0;
  for (const rva::TumEntry& entry : *entries) {
    rva::require(std::isfinite(entry.time_s), "a time is a number");
    rva::require(!entry.file.empty(), "a file has a name");
  }
  return 0;
}
