#include <algorithm>
#include <array>
#include <utility>

#include "sim/sensor/block_matching.hpp"

namespace rva {

namespace {

// A star: near neighbours for detail, far ones for dots that lie some pixels away.
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
    const int from_v = std::clamp(v - reach_px, 0, image.height() - 1);
    for (int u = 0; u < bordered.width(); ++u)
      bordered(u, v) = image(std::clamp(u - reach_px, 0, image.width() - 1), from_v);
  }
  return bordered;
}

}  // namespace

Image<std::uint16_t> census(const InfraredImage& image, int threshold) {
  const InfraredImage bordered = with_border(image);
  Image<std::uint16_t> bits(image.width(), image.height());
  for (int v = 0; v < image.height(); ++v) {
    const std::uint16_t* const center = &bordered(reach_px, v + reach_px);
    std::uint16_t* const out = &bits(0, v);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      const std::uint16_t* const other =
          &bordered(reach_px + neighbours[i].first, v + reach_px + neighbours[i].second);
      for (int u = 0; u < image.width(); ++u)
        out[u] = static_cast<std::uint16_t>(out[u] | ((other[u] > center[u] + threshold ? 1 : 0) << i));
    }
  }
  return bits;
}

}  // namespace rva
