#include "capture/formats.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto info = rva::load_or_refuse([&] { return rva::parse_open3d_json(text, "intrinsic.json"); });
  if (!info) return 0;
  info->depth.check();
  rva::require(info->depth_unit_m > 0.0 && info->depth_unit_m <= 1.0, "a depth unit is within (0, 1] m");
  rva::require(info->source_json == text, "the description is kept as it was read");
  return 0;
}
