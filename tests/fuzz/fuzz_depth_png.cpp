#include "depth/image_file.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto png = std::as_bytes(std::span(data, size));
  const auto image = rva::load_or_refuse([&] { return rva::decode_depth(png, "depth.png"); });
  if (image) {
    rva::require(rva::decode_depth(rva::encode_png(*image), "again.png") == *image,
                 "an image outlives being written and read");
  }
  return 0;
}
