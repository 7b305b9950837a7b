#include <vector>

#include "capture/rosbag2/db3_messages.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto image = rva::load_or_refuse([&] {
    return rva::parse_db3_image({bytes.begin(), bytes.end()}, "message");
  });
  if (image) {
    const auto depth = rva::load_or_refuse([&] { return rva::depth_of(*image, 0.001, "message"); });
    rva::require(!depth || (depth->width() == image->width && depth->height() == image->height),
                 "a depth image is of the size that is stated");
    static_cast<void>(rva::load_or_refuse([&] { return rva::color_of(*image, "message"); }));
    static_cast<void>(rva::load_or_refuse([&] { return rva::gray_of(*image, "message"); }));
  }
  const auto values = rva::load_or_refuse([&] { return rva::parse_db3_values(bytes, "message"); });
  if (!values) return 0;
  const auto camera = rva::load_or_refuse([&] { return rva::intrinsics_from(*values, "message"); });
  if (camera) camera->check();
  const auto transform = rva::load_or_refuse([&] { return rva::transform_from(*values, "message"); });
  rva::require(!transform || transform->linear().isUnitary(1e-9), "a transform turns and moves, no more");
  return 0;
}
