// Infrared images for the matcher's tests, from seeds.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "stereo/block_matching.hpp"

namespace rva::test {

/// Every pixel by itself, 0 to 1023.
inline InfraredImage white_image(int width, int height, std::uint64_t seed) {
  Random random(seed);
  InfraredImage image(width, height);
  for (std::uint16_t& pixel : image.pixels()) pixel = static_cast<std::uint16_t>(random.bits() % 1024);
  return image;
}

struct StereoPair {
  InfraredImage left;
  InfraredImage right;
};

/// Cut from one wide random image, so that all of the left one's column u is at u - disparity in the right
/// one.
inline StereoPair shifted_pair(int width, int height, int disparity, std::uint64_t seed) {
  const InfraredImage wide = white_image(width + disparity, height, seed);
  StereoPair pair{InfraredImage(width, height), InfraredImage(width, height)};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      pair.left(u, v) = wide(u, v);
      pair.right(u, v) = wide(u + disparity, v);
    }
  }
  return pair;
}

/// Normal noise on an image of 10 bits.
inline InfraredImage noisy(const InfraredImage& image, double deviation, std::uint64_t seed) {
  Random random(seed);
  InfraredImage out = image;
  for (std::uint16_t& pixel : out.pixels())
    pixel = static_cast<std::uint16_t>(
        std::lround(std::fmin(1023.0, std::fmax(0.0, pixel + deviation * random.normal()))));
  return out;
}

/// Round blobs of light, brightest at their centres; known at every point, not only at pixels.
class BlobTexture {
 public:
  BlobTexture(int width, int height, double sigma_px, std::uint64_t seed) : sigma_px_(sigma_px) {
    Random random(seed);
    constexpr double pixels_per_blob = 18.0;
    constexpr double margin = 30.0;
    const double area = (width + 2.0 * margin) * (height + 2.0 * margin);
    for (int i = 0; i < area / pixels_per_blob; ++i)
      blobs_.push_back({random.uniform(-margin, width + margin), random.uniform(-margin, height + margin),
                        random.uniform(50.0, 250.0)});
  }

  /// What an imager sees that is `shift_px` further right than the texture, rounded to whole levels.
  [[nodiscard]] InfraredImage seen(int width, int height, double shift_px) const {
    Image<double> light(width, height, 100.0);
    for (const Blob& blob : blobs_) draw({blob.x - shift_px, blob.y, blob.peak}, light);
    InfraredImage image(width, height);
    for (std::size_t i = 0; i < image.size(); ++i)
      image[i] = static_cast<std::uint16_t>(std::lround(std::fmin(1023.0, light[i])));
    return image;
  }

 private:
  struct Blob {
    double x;
    double y;
    double peak;
  };

  void draw(const Blob& blob, Image<double>& light) const {
    const double reach = 5.0 * sigma_px_;
    const auto first = [reach](double at) { return static_cast<int>(std::fmax(0.0, std::ceil(at - reach))); };
    for (int v = first(blob.y); v < light.height() && v < blob.y + reach; ++v) {
      for (int u = first(blob.x); u < light.width() && u < blob.x + reach; ++u) {
        const double squared = (u - blob.x) * (u - blob.x) + (v - blob.y) * (v - blob.y);
        light(u, v) += blob.peak * std::exp(-0.5 * squared / (sigma_px_ * sigma_px_));
      }
    }
  }

  double sigma_px_;
  std::vector<Blob> blobs_;
};

}  // namespace rva::test
