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
      color_of_(companions(files_.depth, files_.color)) {
  for (const Imager imager : both_imagers)
    infrared_of_[imager] = companions(files_.depth, files_.infrared[{imager, Light::projector}]);
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

std::optional<FineGrayImage> FolderCapture::infrared_of(std::size_t depth_frame, Imager imager) const {
  const std::vector<fs::path>& files = files_.infrared.at({imager, Light::projector});
  const auto own = infrared_of_.at(imager).at(depth_frame);
  const bool of_all_frames = files.size() == 1 && info().infrared && info().infrared->frames > 1;
  if (!own && !of_all_frames) return std::nullopt;
  return fine_gray(read_infrared_of(files[own.value_or(0)], Light::projector));
}

bool FolderCapture::has_infrared(Imager imager, Light light) const {
  const auto found = files_.infrared.find({imager, light});
  return found != files_.infrared.end() && !found->second.empty();
}

// Images under the lamp count as those under the projector where nothing else is stated.
Image<float> FolderCapture::read_infrared_of(const fs::path& file, Light light) const {
  const std::optional<InfraredBurst>& burst =
      light == Light::lamp && info().lamp ? info().lamp : info().infrared;
  return of_size(read_infrared(file, burst.value_or(InfraredBurst{}).per_grey_level), file, info().depth);
}

std::optional<Image<float>> FolderCapture::infrared_mean(Imager imager, Light light) const {
  if (!has_infrared(imager, light)) return std::nullopt;
  const std::vector<fs::path>& files = files_.infrared.at({imager, light});
  Image<float> sum(info().depth.width, info().depth.height);
  for (const fs::path& file : files) {
    const Image<float> image = read_infrared_of(file, light);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += image[i];
  }
  for (float& value : sum.pixels()) value /= static_cast<float>(files.size());
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
