#include "capture/images/depth_file.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

// The first byte chooses the kind of file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto file = std::as_bytes(std::span(data, size)).subspan(1);
  const auto image = rva::load_or_refuse([&]() -> rva::StoredDepth {
    switch (data[0] % 4) {
      case 3:
        return rva::StoredDepth(rva::decode_exr(file, "depth.exr"));
      case 0:
        return rva::decode_tiff(file, "depth.tiff");
      case 1:
        return rva::decode_pgm(file, "depth.pgm");
      default:
        return rva::decode_npy(file, "depth.npy");
    }
  });
  if (image) {
    const bool has_pixels = std::visit([](const auto& pixels) { return !pixels.empty(); }, *image);
    rva::require(has_pixels, "an image has pixels");
  }
  return 0;
}
