#include "capture/formats.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

namespace {

void require_rigid(const std::optional<rva::Transform>& transform) {
  if (!transform) return;
  const Eigen::Matrix3d rotation = transform->linear();
  rva::require(rotation.isUnitary(1e-12) && rotation.determinant() > 0.0, "a rotation is orthonormal");
  rva::require(transform->translation().allFinite(), "a translation is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto info = rva::load_or_refuse([&] { return rva::parse_capture_json(text, "capture.json"); });
  if (!info) return 0;
  info->depth.check();
  if (info->color) info->color->check();
  require_rigid(info->color_from_depth);
  if (info->pose) require_rigid(info->pose->world_from_camera);
  rva::require(info->source_json == text, "the description is kept as it was read");
  return 0;
}
