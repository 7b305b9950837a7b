// Answers cases of the agreement test: reads them on stdin, writes masks and boxes on stdout.
//
// A case: int32 method (0 constant, 1 gaussian, 2 regions of a mask), initial frames, final frames, width,
// height, least blob; float64 unit, threshold, clip, sigmas, join; then the frames as uint16, initial first
// (for method 2 one frame that is the mask). The answer: the mask as bytes, int32 count, count boxes of 4
// int32.
#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "depth/depth_statistics.hpp"
#include "detect/regions/regions.hpp"
#include "detect/thesis/constant.hpp"
#include "detect/thesis/gaussian.hpp"

namespace {

using namespace rva;

struct Header {
  std::array<std::int32_t, 6> numbers;
  std::array<double, 5> parameters;
};

template <typename Value>
bool read(Value* to, std::size_t count) {
  return std::fread(to, sizeof(Value), count, stdin) == count;
}

template <typename Value>
void write(const Value* from, std::size_t count) {
  std::fwrite(from, sizeof(Value), count, stdout);
}

std::vector<DepthImage> read_frames(int count, int width, int height) {
  std::vector<DepthImage> frames(static_cast<std::size_t>(count), DepthImage(width, height));
  for (DepthImage& frame : frames) {
    if (!read(frame.data(), frame.size())) throw std::runtime_error("the case ends early");
  }
  return frames;
}

DepthStatistics statistics_of(const std::vector<DepthImage>& frames) {
  DepthStatistics statistics(frames[0].width(), frames[0].height());
  statistics.add(frames);
  return statistics;
}

Mask changed(const Header& header, const std::vector<DepthImage>& initial,
             const std::vector<DepthImage>& final) {
  const auto [unit_m, threshold_m, clip_m, sigmas, join_px] = header.parameters;
  switch (header.numbers[0]) {
    case 0:
      return compare_constant(initial[0], final[0], unit_m, {threshold_m, clip_m}).changed;
    case 1:
      return compare_gaussian(statistics_of(initial), statistics_of(final), unit_m, {sigmas}).changed;
    default: {
      Mask mask(initial[0].width(), initial[0].height());
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = static_cast<std::uint8_t>(initial[0][i]);
      return mask;
    }
  }
}

void answer_all() {
  Header header{};
  while (read(header.numbers.data(), header.numbers.size()) &&
         read(header.parameters.data(), header.parameters.size())) {
    const auto [method, initial_frames, final_frames, width, height, min_blob] = header.numbers;
    const std::vector<DepthImage> initial = read_frames(initial_frames, width, height);
    const std::vector<DepthImage> final = read_frames(final_frames, width, height);
    const Mask mask = changed(header, initial, final);
    write(mask.data(), mask.size());
    const std::vector<Region> regions = find_regions(mask, {min_blob, header.parameters[4]});
    const auto count = static_cast<std::int32_t>(regions.size());
    write(&count, 1);
    for (const Region& region : regions) {
      const std::array<std::int32_t, 4> box{region.box.x, region.box.y, region.box.width, region.box.height};
      write(box.data(), box.size());
    }
  }
}

}  // namespace

int main() {
  try {
    answer_all();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reference_probe: %s\n", error.what());
    return 1;
  }
}
