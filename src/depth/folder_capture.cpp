#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/formats.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

// Of each depth file, the other that goes with it.
std::vector<std::optional<std::size_t>> companions(const std::vector<fs::path>& depth,
                                                   const std::vector<fs::path>& others) {
  std::map<fs::path, std::size_t> by_name;
  for (std::size_t i = 0; i < others.size(); ++i) by_name.emplace(others[i].stem(), i);
  std::vector<std::optional<std::size_t>> found(depth.size());
  bool any = false;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const auto same = by_name.find(depth[i].stem());
    if (same == by_name.end()) continue;
    found[i] = same->second;
    any = true;
  }
  for (std::size_t i = 0; !any && i < std::min(depth.size(), others.size()); ++i) found[i] = i;
  return found;
}

template <typename Pixel>
Image<Pixel> of_size(Image<Pixel> image, const fs::path& file, const Intrinsics& stated) {
  if (image.width() == stated.width && image.height() == stated.height) return image;
  throw Error(printable(file),
              fmt::format("{}x{} pixels where the capture states {}x{}", image.width(), image.height(),
                          stated.width, stated.height),
              "record the capture again");
}

}  // namespace

std::vector<fs::path> image_files(const fs::path& folder, const std::vector<std::string_view>& endings) {
  std::vector<fs::path> files;
  std::error_code failure;
  if (!fs::exists(folder, failure) && !failure) return files;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path& path = entry->path();
    std::string ending = path.extension().native();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    const bool hidden = path.filename().native().starts_with('.');  // other systems leave such beside images
    if (!hidden && std::ranges::find(endings, ending) != endings.end()) files.push_back(path);
  }
  if (failure) {
    throw Error(printable(folder), fmt::format("cannot be read ({})", failure.message()),
                "check its permissions");
  }
  std::ranges::sort(files);
  return files;
}

FolderCapture::FolderCapture(const fs::path& place, CaptureInfo info, FrameFiles files)
    : Capture(std::move(info)),
      files_(std::move(files)),
      no_depth_(this->info().no_depth, this->info().depth_unit_m),
      color_of_(companions(files_.depth, files_.color)),
      infrared_of_(companions(files_.depth, files_.infrared)) {
  require_possible(this->info(), printable(place));
  if (files_.depth.empty()) throw Error(printable(place), "holds no depth frame", "record the capture again");
}

DepthImage FolderCapture::stored_depth(std::size_t i) const {
  const fs::path& file = files_.depth.at(i);
  return of_size(read_depth(file), file, info().depth);
}

DepthImage FolderCapture::depth(std::size_t i) const {
  DepthImage image = stored_depth(i);
  no_depth_.clear(image, [this] { return stored_depth(0); });
  return image;
}

bool FolderCapture::marks_no_depth_by_zero() const {
  return no_depth_.are_zero([this] { return stored_depth(0); });
}

std::vector<std::string> FolderCapture::depth_notes() const {
  return no_depth_.notes([this] { return stored_depth(0); });
}

ColorImage FolderCapture::color(std::size_t i) const {
  const fs::path& file = files_.color.at(i);
  ColorImage image = read_color(file);
  return info().color ? of_size(std::move(image), file, *info().color) : image;
}

std::optional<ColorImage> FolderCapture::color_of(std::size_t depth_frame) const {
  const auto i = color_of_.at(depth_frame);
  return i ? std::optional(color(*i)) : std::nullopt;
}

std::optional<GrayImage> FolderCapture::infrared_of(std::size_t depth_frame) const {
  const auto i = infrared_of_.at(depth_frame);
  if (!i) return std::nullopt;
  const Image<float> grey = infrared(*i);
  constexpr float white = 255.0F;
  GrayImage image(grey.width(), grey.height());
  for (std::size_t k = 0; k < grey.size(); ++k)
    image[k] = static_cast<std::uint8_t>(std::lround(std::min(grey[k], white)));
  return image;
}

Image<float> FolderCapture::infrared(std::size_t file) const {
  const fs::path& path = files_.infrared[file];
  const double counts = info().infrared.value_or(InfraredCounts{}).per_grey_level;
  return of_size(read_infrared(path, counts), path, info().depth);
}

std::optional<Image<float>> FolderCapture::infrared_mean() const {
  if (files_.infrared.empty()) return std::nullopt;
  Image<float> sum = infrared(0);
  for (std::size_t file = 1; file < files_.infrared.size(); ++file) {
    const Image<float> image = infrared(file);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += image[i];
  }
  const auto images = static_cast<float>(files_.infrared.size());
  for (float& value : sum.pixels()) value /= images;
  return sum;
}

FrameMetadata FolderCapture::metadata_of(std::size_t depth_frame) const {
  const std::string name = files_.depth.at(depth_frame).stem();
  std::size_t number = 0;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), number);
  if (parsed.ec != std::errc{} || parsed.ptr != name.data() + name.size()) return {};
  const auto found = files_.metadata.find(number);
  return found == files_.metadata.end() ? FrameMetadata{} : found->second;
}

}  // namespace rva
