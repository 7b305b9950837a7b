#include "capture/formats.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto frames = rva::load_or_refuse([&] { return rva::parse_frame_lines(text, "frames.jsonl"); });
  if (!frames) return 0;
  std::string again;
  for (const auto& [number, metadata] : *frames) again += rva::frame_line(number, metadata);
  rva::require(rva::parse_frame_lines(again, "again.jsonl") == *frames,
               "metadata outlives being written and read");
  return 0;
}
