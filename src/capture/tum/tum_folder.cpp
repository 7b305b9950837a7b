#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>

#include "capture/formats.hpp"
#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr double tum_unit_m = 1.0 / 5000.0;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// A list may only name files inside its folder, as the benchmark's tools write it.
fs::path inside(const fs::path& folder, const TumEntry& entry, const std::string& list) {
  const fs::path relative = fs::path(entry.file).lexically_normal();
  if (relative.is_absolute() || *relative.begin() == "..") {
    throw Error(list, fmt::format("'{}' lies outside the folder", printable(entry.file)), "correct the list");
  }
  return folder / relative;
}

// Pairing each depth frame with the nearest colour image would repeat images. Overlays need only the one
// nearest in time to the first depth frame.
std::vector<fs::path> nearest_color(const fs::path& folder, double time_s) {
  const fs::path list = folder / "rgb.txt";
  std::error_code ignored;
  if (!fs::exists(list, ignored)) return {};
  const std::vector<TumEntry> entries = parse_tum_list(read_text_file(list), printable(list));
  const TumEntry* nearest = nullptr;
  double least_s = std::numeric_limits<double>::infinity();
  for (const TumEntry& entry : entries) {
    if (std::abs(entry.time_s - time_s) < least_s) {
      least_s = std::abs(entry.time_s - time_s);
      nearest = &entry;
    }
  }
  return nearest == nullptr ? std::vector<fs::path>{}
                            : std::vector{inside(folder, *nearest, printable(list))};
}

}  // namespace

std::vector<TumEntry> parse_tum_list(const std::string& text, const std::string& source) {
  std::vector<TumEntry> entries;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    TumEntry entry;
    // The rest of the line is the file's name, which may have spaces.
    if (!(words >> entry.time_s >> std::ws) || !std::getline(words, entry.file) ||
        !std::isfinite(entry.time_s)) {
      throw Error(fmt::format("{}:{}", source, number), "is not 'seconds file'", "correct the list");
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::unique_ptr<Capture> open_tum_folder(const fs::path& folder, const CaptureOptions& options) {
  if (!options.intrinsics) {
    throw Error(printable(folder), "a TUM folder states no intrinsics",
                "give the intrinsics of the depth camera (fx, fy, cx, cy)");
  }
  const fs::path list = folder / "depth.txt";
  const std::vector<TumEntry> entries = parse_tum_list(read_text_file(list), printable(list));
  std::vector<fs::path> depth_files;
  depth_files.reserve(entries.size());
  for (const TumEntry& entry : entries) depth_files.push_back(inside(folder, entry, printable(list)));
  if (depth_files.empty()) throw Error(printable(list), "lists no depth frame", "record the capture again");

  CaptureInfo info;
  info.format = "tum";
  info.depth = *options.intrinsics;
  info.depth_unit_m = tum_unit_m;
  info.unit_is_assumed = true;
  settle_unit(options, info);
  info.no_depth = options.no_depth;
  const DepthImage first = read_depth_file(depth_files.front(), info.depth_unit_m);
  info.depth.width = first.width();
  info.depth.height = first.height();
  info.depth.check();
  // The benchmark's depth images are registered to colour.
  info.color = info.depth;
  info.color_from_depth = Transform::Identity();
  FrameFiles files{std::move(depth_files), nearest_color(folder, entries.front().time_s)};
  files.color_of.resize(files.depth.size());
  if (!files.color.empty()) files.color_of.front() = 0;
  return std::make_unique<FolderCapture>(folder, std::move(info), std::move(files));
}

}  // namespace rva
