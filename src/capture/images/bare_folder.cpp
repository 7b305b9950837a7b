#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "capture/formats.hpp"
#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr double usual_unit_m = 0.001;

}  // namespace

std::vector<fs::path> bare_depth_files(const fs::path& folder) {
  std::vector<fs::path> files = depth_files(folder / "depth");
  return files.empty() ? depth_files(folder) : files;
}

std::unique_ptr<Capture> open_bare_folder(const fs::path& folder, const CaptureOptions& options) {
  FrameFiles files{bare_depth_files(folder), {}};
  if (!options.intrinsics)
    throw Error(
        printable(folder),
        fmt::format("contains {} images and no description of the camera", files.depth.size()),
        "give the intrinsics of the depth camera (fx, fy, cx, cy), and the depth unit if it is not 1 mm");
  CaptureInfo info;
  info.format = "images";
  info.depth = *options.intrinsics;
  info.depth_unit_m = usual_unit_m;
  info.unit_is_assumed = true;
  info.no_depth = options.no_depth;
  settle_unit(options, info);
  const DepthImage first = read_depth_file(files.depth.front(), info.depth_unit_m);
  info.depth.width = first.width();
  info.depth.height = first.height();
  info.depth.check();
  return std::make_unique<FolderCapture>(folder, std::move(info), std::move(files));
}

}  // namespace rva
