#include <algorithm>
#include <array>
#include <utility>

#include "core/parallel.hpp"
#include "core/vector_clones.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

namespace {

// Neighbours in a star: near ones for detail, far ones for dots that are some pixels away.
constexpr std::array<std::pair<int, int>, 16> neighbours{{{-1, -1},
                                                          {1, -1},
                                                          {-1, 1},
                                                          {1, 1},
                                                          {-2, 0},
                                                          {2, 0},
                                                          {0, -2},
                                                          {0, 2},
                                                          {-3, -1},
                                                          {3, 1},
                                                          {-3, 2},
                                                          {3, -2},
                                                          {-1, -3},
                                                          {1, 3},
                                                          {2, -3},
                                                          {-2, 3}}};
constexpr int reach_px = 3;

InfraredImage with_border(const InfraredImage& image) {
  InfraredImage bordered(image.width() + 2 * reach_px, image.height() + 2 * reach_px);
  for (int v = 0; v < bordered.height(); ++v) {
    const std::uint16_t* const from = &image(0, std::clamp(v - reach_px, 0, image.height() - 1));
    std::uint16_t* const out = &bordered(0, v);
    std::fill_n(out, reach_px, from[0]);
    std::copy_n(from, image.width(), out + reach_px);
    std::fill_n(out + reach_px + image.width(), reach_px, from[image.width() - 1]);
  }
  return bordered;
}

RVA_VECTOR_CLONES
void compare(const std::uint16_t* center, const std::uint16_t* other, int count, int threshold,
             std::uint16_t bit, std::uint16_t* out) {
  for (int u = 0; u < count; ++u)
    out[u] = static_cast<std::uint16_t>(out[u] | (other[u] > center[u] + threshold ? bit : 0));
}

}  // namespace

Image<std::uint16_t> census(const InfraredImage& image, int threshold) {
  const InfraredImage bordered = with_border(image);
  Image<std::uint16_t> bits(image.width(), image.height());
  parallel_bands(image.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (std::size_t i = 0; i < neighbours.size(); ++i) {
        const auto [right, down] = neighbours[i];
        compare(&bordered(reach_px, v + reach_px), &bordered(reach_px + right, v + reach_px + down),
                image.width(), threshold, static_cast<std::uint16_t>(1U << i), &bits(0, v));
      }
    }
  });
  return bits;
}

}  // namespace rva
