#include "inspect/marking.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/quantile.hpp"
#include "core/units.hpp"
#include "depth/image_file.hpp"
#include "inspect/inspection_map.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

// The median depth of the middle half of a box, metres; empty if less than a third of it is measured.
std::optional<double> depth_in_middle_m(const DepthImage& depth, const Box& box, double depth_unit_m) {
  std::vector<std::uint16_t> measured;
  std::size_t pixels = 0;
  for (int v = box.y + box.height / 4; v < box.y + box.height - box.height / 4; ++v) {
    for (int u = box.x + box.width / 4; u < box.x + box.width - box.width / 4; ++u) {
      ++pixels;
      if (depth(u, v) != no_depth) measured.push_back(depth(u, v));
    }
  }
  if (measured.empty() || 3 * measured.size() < pixels) return std::nullopt;
  return quantile(measured, 0.5) * depth_unit_m;
}

}  // namespace

void require_inside(const Box& box, int width, int height) {
  const bool inside = box.x >= 0 && box.y >= 0 && box.width > 0 && box.height > 0 && box.width <= width &&
                      box.height <= height && box.x <= width - box.width && box.y <= height - box.height;
  if (!inside)
    throw Error("mark", "is not inside the picture",
                fmt::format("mark a part of its {} x {} pixels", width, height));
}

MarkedFinding located_mark(const Capture& capture, const Box& box, const PanTiltChain& chain) {
  const CaptureInfo& info = capture.info();
  require_inside(box, info.depth.width, info.depth.height);
  MarkedFinding marked;
  marked.box = box;
  const DepthImage depth = capture.depth(capture.depth_frames() - 1);
  const std::optional<double> depth_m = depth_in_middle_m(depth, box, info.depth_unit_m);
  if (!depth_m) return marked;
  const Eigen::Vector2d middle(box.x + (box.width - 1) / 2.0, box.y + (box.height - 1) / 2.0);
  marked.position_m = info.depth.deproject(middle, *depth_m);
  marked.in_foot_m = map_from_camera(info, chain) * *marked.position_m;
  marked.size_mm = {mm_per_m * box.width * *depth_m / info.depth.fx,
                    mm_per_m * box.height * *depth_m / info.depth.fy};
  return marked;
}

std::string review_picture(const InspectionFolder& folder, const Inspection& inspection, int view) {
  const fs::path result = folder.result(inspection, view);
  std::error_code ignored;
  const fs::path color = result / "final_color.png";
  const fs::path picture = fs::exists(color, ignored) ? color : result / "final_depth.png";
  return picture.lexically_relative(folder.path()).string();
}

std::string keep_picture(const InspectionFolder& folder, const std::string& kind, const ColorImage& picture) {
  const fs::path pictures = folder.path() / kind;
  folder.require_no_links(pictures);
  make_folders(pictures);
  int number = 1;
  const auto name = [&] { return fmt::format("{:03}.png", number); };
  std::error_code ignored;
  while (fs::exists(fs::symlink_status(pictures / name(), ignored))) ++number;
  replace_file(pictures / name(), encode_png(picture));
  return (fs::path(kind) / name()).string();
}

}  // namespace rva
