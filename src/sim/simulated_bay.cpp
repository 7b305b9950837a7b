#include "sim/simulated_bay.hpp"

#include <utility>

#include "core/random.hpp"

namespace rva {

SimulatedBay::SimulatedBay(Scene before, Scene after, std::uint64_t seed,
                           const std::function<PanTilt()>& joints, const std::function<double()>& lamp)
    : before_(std::move(before), {}, seed, ColorFrames::all, joints, lamp),
      after_(std::move(after), {}, mix(seed, 1), ColorFrames::all, joints, lamp) {}

void SimulatedBay::set_light(Light light) {
  before_.set_light(light);
  after_.set_light(light);
}

void SimulatedBay::set_exposure(const Exposure& exposure) {
  before_.set_exposure(exposure);
  after_.set_exposure(exposure);
}

std::optional<CameraFrame> SimulatedBay::wait_for_frame() {
  std::optional<CameraFrame> frame = (done_ ? after_ : before_).wait_for_frame();
  if (frame) frame->number = number_++;
  return frame;
}

}  // namespace rva
