#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "capture/formats.hpp"
#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Companions = std::vector<std::optional<std::size_t>>;  ///< by depth file, its companion's index

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

// The last number in a file's name, without leading zeros: "7" in "color_007", "42" in "rs-42-left"; empty
// where there is none.
std::string number_in(const fs::path& file) {
  const std::string name = file.stem();
  const auto last = std::ranges::find_if(name.rbegin(), name.rend(), is_digit);
  const auto before = std::find_if_not(last, name.rend(), is_digit);
  std::string digits(before.base(), last.base());
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - (digits.empty() ? 0 : 1)));
  return digits;
}

// Pairs files with equal keys; pairs none if two of the other files have the same key.
Companions with_equal(const std::vector<fs::path>& depth, const std::vector<fs::path>& others,
                      const std::function<std::string(const fs::path&)>& key_of) {
  std::map<std::string, std::size_t> by_key;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (const bool is_new = by_key.emplace(key_of(others[i]), i).second; !is_new) return {};
  }
  Companions found(depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const std::string key = key_of(depth[i]);
    const auto same = by_key.find(key);
    if (!key.empty() && same != by_key.end()) found[i] = same->second;
  }
  return found;
}

bool pairs_any(const Companions& companions) {
  return std::ranges::any_of(companions, [](const auto& other) { return other.has_value(); });
}

// Pairs files by name, or else by number, but never by their position in the two lists, since the streams of
// a camera seldom begin with the same frame.
Companions companions(const std::vector<fs::path>& depth, const std::vector<fs::path>& others) {
  for (const auto& key_of : {std::function<std::string(const fs::path&)>(
                                 [](const fs::path& file) { return file.stem().string(); }),
                             std::function<std::string(const fs::path&)>(number_in)}) {
    Companions found = with_equal(depth, others, key_of);
    if (pairs_any(found)) return found;
  }
  return Companions(depth.size());
}

// Compares runs of digits by value: "frame2" comes before "frame10". With equal values, characters decide.
bool comes_before(const fs::path& a, const fs::path& b) {
  const std::string& one = a.native();
  const std::string& other = b.native();
  std::size_t i = 0;
  std::size_t j = 0;
  const auto run_at = [](const std::string& text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && is_digit(text[end])) ++end;
    return std::string_view(text).substr(from, end - from);
  };
  const auto value = [](std::string_view digits) {
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return std::pair(digits.size(), digits);
  };
  while (i < one.size() && j < other.size()) {
    const std::string_view run = run_at(one, i);
    const std::string_view other_run = run_at(other, j);
    if (run.empty() || other_run.empty()) {
      if (one[i] != other[j]) return one[i] < other[j];
      ++i;
      ++j;
      continue;
    }
    if (value(run) != value(other_run)) return value(run) < value(other_run);
    i += run.size();
    j += other_run.size();
  }
  if (i < one.size() || j < other.size()) return j < other.size();
  return one < other;
}

template <typename Pixel, typename Meaning>
Image<Pixel, Meaning> of_size(Image<Pixel, Meaning> image, const fs::path& file, const Intrinsics& stated) {
  if (image.width() == stated.width && image.height() == stated.height) return image;
  throw Error(printable(file),
              fmt::format("has {}x{} pixels, but the capture states {}x{}", image.width(), image.height(),
                          stated.width, stated.height),
              "record the capture again");
}

Error without_depth(const fs::path& source) {
  std::error_code failure;
  for (fs::directory_iterator entry(source / "depth", failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->is_regular_file())
      return {printable(source),
              fmt::format(
                  "contains no depth frame in a supported format: depth/ has {}, but PNG, TIFF, PGM or NumPy "
                  "files are needed",
                  printable(entry->path().filename())),
              "convert its images"};
  }
  return {printable(source), "contains no depth frame", "record the capture again"};
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
    const bool hidden = path.filename().native().starts_with('.');  // other systems leave such files
    if (!hidden && std::ranges::find(endings, ending) != endings.end()) files.push_back(path);
  }
  if (failure) {
    throw Error(printable(folder), fmt::format("cannot be read ({})", failure.message()),
                "check its permissions");
  }
  std::ranges::sort(files, comes_before);
  return files;
}

FolderCapture::FolderCapture(const fs::path& source, CaptureInfo info, FrameFiles files)
    : Capture(std::move(info)),
      files_(std::move(files)),
      no_depth_(this->info().no_depth, this->info().depth_unit_m),
      color_of_(files_.color_of.empty() ? companions(files_.depth, files_.color) : files_.color_of) {
  for (const Imager imager : both_imagers)
    infrared_of_[imager] = companions(files_.depth, files_.infrared[{imager, Light::projector}]);
  require_possible(this->info(), printable(source));
  if (files_.depth.empty()) throw without_depth(source);
}

DepthImage FolderCapture::stored_depth(std::size_t i) const {
  const fs::path& file = files_.depth.at(i);
  return of_size(read_depth_file(file, info().depth_unit_m), file, info().depth);
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

// Images under the lamp have the scale of those under the projector where no scale is stated.
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
