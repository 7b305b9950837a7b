// Images in memory.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rva {

/// A dense image: row by row, no padding. Pixel (u, v) is column u from the left, row v from the top,
/// both from 0. Copies are deep.
///
/// `Meaning` distinguishes images of one pixel type whose values mean different things: a label image cannot
/// be passed as a depth image.
template <typename Pixel, typename Meaning = Pixel>
class Image {
 public:
  /// The type of a pixel.
  using Value = Pixel;

  Image() = default;
  /// An image of one value. Width and height are in pixels and not negative.
  Image(int width, int height, Pixel fill = {})
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  /// Number of columns.
  [[nodiscard]] int width() const { return width_; }
  /// Number of rows.
  [[nodiscard]] int height() const { return height_; }
  /// Number of pixels.
  [[nodiscard]] std::size_t size() const { return pixels_.size(); }
  /// Whether there are no pixels.
  [[nodiscard]] bool empty() const { return pixels_.empty(); }

  /// Pixel (u, v), which must be inside the image.
  [[nodiscard]] Pixel& operator()(int u, int v) { return pixels_[index(u, v)]; }
  /// @overload
  [[nodiscard]] const Pixel& operator()(int u, int v) const { return pixels_[index(u, v)]; }
  /// Pixel by its index in row-major order.
  [[nodiscard]] Pixel& operator[](std::size_t i) { return pixels_[i]; }
  /// @overload
  [[nodiscard]] const Pixel& operator[](std::size_t i) const { return pixels_[i]; }

  /// The first pixel; the others follow in row-major order.
  [[nodiscard]] Pixel* data() { return pixels_.data(); }
  /// @overload
  [[nodiscard]] const Pixel* data() const { return pixels_.data(); }
  /// All pixels in row-major order.
  [[nodiscard]] std::span<Pixel> pixels() { return pixels_; }
  /// @overload
  [[nodiscard]] std::span<const Pixel> pixels() const { return pixels_; }

  /// Whether width and height are equal.
  template <typename Other, typename OtherMeaning>
  [[nodiscard]] bool same_size(const Image<Other, OtherMeaning>& other) const {
    return width_ == other.width() && height_ == other.height();
  }

  bool operator==(const Image&) const = default;

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    assert(u >= 0 && u < width_ && v >= 0 && v < height_);
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

/// Depth along z of the depth imager, in the capture's depth units.
using DepthImage = Image<std::uint16_t, struct DepthInUnits>;
/// The value of pixels without a measurement in a DepthImage.
inline constexpr std::uint16_t no_depth = 0;

/// 255 where the pixel belongs to the mask, otherwise 0.
using Mask = Image<std::uint8_t, struct InMask>;
inline constexpr std::uint8_t mask_set = 255;  ///< the value of a pixel that belongs to a Mask

/// Brightness, 0 to 255.
using GrayImage = Image<std::uint8_t, struct GreyLevel>;

/// Brightness in 256ths of a grey level, 0 to 65280: the mean of several images has fractions.
using FineGrayImage = Image<std::uint16_t, struct FineGreyLevel>;
inline constexpr int fine_steps_per_grey_level = 256;  ///< the unit of a FineGrayImage

/// Converts grey levels to 256ths, rounded.
/// @param levels grey levels, with or without fractions; clamped to 0 to 255
template <typename Level, typename Meaning>
[[nodiscard]] FineGrayImage fine_gray(const Image<Level, Meaning>& levels) {
  constexpr float white = 255.0F;
  FineGrayImage fine(levels.width(), levels.height());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const float level = std::clamp(static_cast<float>(levels[i]), 0.0F, white);
    fine[i] = static_cast<std::uint16_t>(std::lround(fine_steps_per_grey_level * level));
  }
  return fine;
}

/// Numbers of objects, as the scene counts them; 0 for none.
using LabelImage = Image<std::uint16_t, struct ObjectLabel>;

/// A colour, 0 to 255 for each component.
struct Rgb {
  std::uint8_t r = 0;  ///< red
  std::uint8_t g = 0;  ///< green
  std::uint8_t b = 0;  ///< blue
  bool operator==(const Rgb&) const = default;
};
/// Colour of each pixel.
using ColorImage = Image<Rgb>;

}  // namespace rva
