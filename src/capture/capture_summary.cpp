#include "capture/capture_summary.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "capture/frame_reader.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

void summarize_depth(const Capture& capture, const Progress& progress, CaptureSummary& summary) {
  std::size_t measured = 0;
  std::size_t pixels = 0;
  std::uint16_t nearest = std::numeric_limits<std::uint16_t>::max();
  std::uint16_t farthest = 0;
  for_each_depth_frame(capture, capture.depth_frames(), progress, [&](const DepthImage& frame) {
    pixels += frame.size();
    for (const std::uint16_t depth : frame.pixels()) {
      if (depth == no_depth) continue;
      ++measured;
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  });
  const double unit_m = capture.info().depth_unit_m;
  summary.fill_rate = static_cast<double>(measured) / static_cast<double>(pixels);
  summary.nearest_m = measured == 0 ? 0.0 : nearest * unit_m;
  summary.farthest_m = farthest * unit_m;
}

void read_colors(const Capture& capture) {
  for (std::size_t i = 0; i < capture.color_frames(); ++i) {
    throw_if_interrupted();
    static_cast<void>(capture.color(i));
  }
}

}  // namespace

CaptureSummary summarize(const Capture& capture, const Progress& progress) {
  CaptureSummary summary;
  summarize_depth(capture, progress, summary);
  read_colors(capture);
  summary.lost = lost_frames(capture);
  summary.notes = capture.info().notes;
  for (const std::string& note : capture.depth_notes()) summary.notes.push_back(note);
  return summary;
}

}  // namespace rva
