#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

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

// Calls `use` with the number and the text of each line that is not empty and no comment.
void for_each_line(const std::string& text, const std::function<void(int, const std::string&)>& use) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty() && line[0] != '#') use(number, line);
  }
}

bool names_depth(const TumEntry& entry) { return entry.file.find("depth") != std::string::npos; }

FrameFiles associated_files(const fs::path& folder, const fs::path& list) {
  const std::string source = printable(list);
  FrameFiles files;
  for (const TumPair& pair : parse_associations(read_text_file(list), source)) {
    files.depth.push_back(inside(folder, pair.depth, source));
    files.color.push_back(inside(folder, pair.color, source));
    files.color_of.emplace_back(files.color.size() - 1);
  }
  return files;
}

FrameFiles files_of_lists(const fs::path& folder, const fs::path& list) {
  const std::string source = printable(list);
  const std::vector<TumEntry> entries = parse_tum_list(read_text_file(list), source);
  FrameFiles files;
  for (const TumEntry& entry : entries) files.depth.push_back(inside(folder, entry, source));
  if (entries.empty()) return files;
  files.color = nearest_color(folder, entries.front().time_s);
  files.color_of.resize(files.depth.size());
  if (!files.color.empty()) files.color_of.front() = 0;
  return files;
}

// @throws Error when no depth frame is listed
FrameFiles listed_files(const fs::path& folder) {
  const fs::path depth_list = folder / "depth.txt";
  std::error_code ignored;
  const bool has_depth_list = fs::exists(depth_list, ignored);
  const fs::path list = has_depth_list ? depth_list : association_list(folder).value_or(depth_list);
  FrameFiles files = has_depth_list ? files_of_lists(folder, list) : associated_files(folder, list);
  if (files.depth.empty()) throw Error(printable(list), "lists no depth frame", "record the capture again");
  return files;
}

}  // namespace

std::vector<TumEntry> parse_tum_list(const std::string& text, const std::string& source) {
  std::vector<TumEntry> entries;
  for_each_line(text, [&](int number, const std::string& line) {
    std::istringstream words(line);
    TumEntry entry;
    // The rest of the line is the file's name, which may have spaces.
    if (!(words >> entry.time_s >> std::ws) || !std::getline(words, entry.file) ||
        !std::isfinite(entry.time_s)) {
      throw Error(fmt::format("{}:{}", source, number), "is not 'seconds file'", "correct the list");
    }
    entries.push_back(std::move(entry));
  });
  return entries;
}

std::vector<TumPair> parse_associations(const std::string& text, const std::string& source) {
  std::vector<TumPair> pairs;
  bool depth_first = false;
  for_each_line(text, [&](int number, const std::string& line) {
    std::istringstream words(line);
    TumEntry first;
    TumEntry second;
    std::string more;
    if (!(words >> first.time_s >> first.file >> second.time_s >> second.file) || words >> more ||
        !std::isfinite(first.time_s) || !std::isfinite(second.time_s))
      throw Error(fmt::format("{}:{}", source, number), "is not 'seconds file seconds file'",
                  "correct the list");
    if (pairs.empty()) depth_first = names_depth(first) && !names_depth(second);
    pairs.push_back(depth_first ? TumPair{std::move(first), std::move(second)}
                                : TumPair{std::move(second), std::move(first)});
  });
  return pairs;
}

std::optional<fs::path> association_list(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"associations.txt", "association.txt", "associate.txt", "assoc.txt"}) {
    if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  }
  return std::nullopt;
}

std::unique_ptr<Capture> open_tum_folder(const fs::path& folder, const CaptureOptions& options) {
  if (!options.intrinsics) {
    throw Error(printable(folder), "a TUM folder states no intrinsics",
                "give the intrinsics of the depth camera (fx, fy, cx, cy)");
  }
  FrameFiles files = listed_files(folder);
  CaptureInfo info;
  info.format = "tum";
  info.depth = *options.intrinsics;
  info.depth_unit_m = tum_unit_m;
  info.unit_is_assumed = true;
  settle_unit(options, info);
  info.no_depth = options.no_depth;
  const DepthImage first = read_depth_file(files.depth.front(), info.depth_unit_m);
  info.depth.width = first.width();
  info.depth.height = first.height();
  info.depth.check();
  // The benchmark's depth images are registered to colour.
  info.color = info.depth;
  info.color_from_depth = Transform::Identity();
  return std::make_unique<FolderCapture>(folder, std::move(info), std::move(files));
}

}  // namespace rva
