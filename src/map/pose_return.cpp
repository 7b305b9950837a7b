#include "map/pose_return.hpp"

#include <algorithm>
#include <utility>

#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

// An approach is judged by few frames, since it may have to be repeated.
constexpr int frames_at_rest = 3;

// What the camera sees from its present pose.
MemoryCapture view_at_rest(Camera& camera) {
  std::vector<MemoryFrame> frames;
  for (int i = 0; i < frames_at_rest; ++i) {
    throw_if_interrupted();
    std::optional<CameraFrame> frame = camera.wait_for_frame();
    if (!frame) throw Error("camera", "the recording ended during an approach", "use a camera that goes on");
    frames.push_back({std::move(frame->depth), {}, std::move(frame->infrared), {}});
  }
  return {camera.info(), std::move(frames)};
}

}  // namespace

bool is_close_enough(const std::vector<double>& off_deg, const PoseReturnOptions& options) {
  const auto made = static_cast<int>(off_deg.size());
  if (off_deg.back() <= options.within_deg || made >= options.approaches) return true;
  return 2 * made >= options.approaches && off_deg.back() <= *std::ranges::min_element(off_deg);
}

ReachedPose return_to_pose(const Rig& rig, const PanTilt& waypoint, BaselinePoses& baseline,
                           std::size_t capture, std::size_t settling_frames, const PoseReturnOptions& options,
                           const OnApproach& on_approach) {
  std::vector<double> off_deg;
  for (int approaches = 1;; ++approaches) {
    const PanTilt joints = approach_and_settle(rig, waypoint, settling_frames);
    const ReachedPose reached{joints, approaches, baseline.turn_deg(capture, view_at_rest(rig.camera))};
    if (reached.off_deg) off_deg.push_back(*reached.off_deg);
    const bool last = !reached.off_deg || is_close_enough(off_deg, options);
    if (on_approach) on_approach(reached, last);
    if (last) return reached;
  }
}

}  // namespace rva
