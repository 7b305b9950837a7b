#include "depth/image_file.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = std::as_bytes(std::span(data, size));
  const auto image = rva::load_or_refuse([&] { return rva::decode_color(file, "color"); });
  if (image) rva::require(!image->empty(), "an image that was read has pixels");
  return 0;
}
