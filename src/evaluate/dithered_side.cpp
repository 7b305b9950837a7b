#include "evaluate/dithered_side.hpp"

#include <cassert>
#include <utility>

#include "core/random.hpp"
#include "detect/detection.hpp"

namespace rva {

DitheredSide::DitheredSide(Scene scene, const StereoSensorOptions& sensor, std::uint64_t seed, int frames)
    : scene_(std::move(scene)),
      sensor_(sensor),
      seed_(seed),
      frames_(frames),
      offsets_(dither_offsets(most_dithers)) {}

void DitheredSide::up_to(int captures) {
  while (views_.size() < static_cast<std::size_t>(captures)) take();
}

std::vector<PlacedChange> DitheredSide::changes_since(const DitheredSide& initial) const {
  assert(initial.views_.size() == views_.size());
  std::vector<PlacedChange> changes;
  for (std::size_t k = 0; k < views_.size(); ++k)
    changes.push_back({disparity_change(initial.statistics_[k], statistics_[k], disparity_m_px() / unit_m()),
                       views_[k].first_from_view});
  return changes;
}

SimulatedCamera DitheredSide::camera(std::size_t number) const {
  Scene scene = scene_;
  scene.stand.pan_deg += offsets_[number].pan_deg;
  scene.stand.tilt_deg += offsets_[number].tilt_deg;
  return {std::move(scene), sensor_, mix(seed_, number), ColorFrames::none};
}

void DitheredSide::take() {
  SimulatedCamera camera = this->camera(views_.size());
  const CaptureInfo info = camera.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (int i = 0; i < frames_; ++i) {
    DepthImage depth = camera.wait_for_frame()->depth;
    statistics.add(depth);
    if (i == 0 && views_.empty()) first_depth_ = std::move(depth);
  }
  if (views_.empty()) {
    info_ = info;
    world_from_first_ = camera.world_from_camera();
  }
  views_.push_back({depth_view(statistics, info.depth, info.depth_unit_m, rva::disparity_m_px(info)),
                    world_from_first_.inverse() * camera.world_from_camera()});
  statistics_.push_back(std::move(statistics));
}

}  // namespace rva
