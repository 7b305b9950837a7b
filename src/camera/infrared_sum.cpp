#include "camera/infrared_sum.hpp"

namespace rva {

void InfraredSum::add(const CameraFrame& frame) {
  for (const auto& [imager, image] : frame.infrared) {
    Sum& sum = sums_.try_emplace(imager, Sum{{image.width(), image.height()}, 0}).first->second;
    for (std::size_t i = 0; i < image.size(); ++i) sum.brightness[i] += image[i];
    ++sum.frames;
  }
  metadata_ = frame.metadata;
}

void InfraredSum::write(Light light, CaptureSink& sink) const {
  for (const auto& [imager, sum] : sums_) {
    FineGrayImage mean(sum.brightness.width(), sum.brightness.height());
    const auto frames = static_cast<std::uint64_t>(sum.frames);
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] = static_cast<std::uint16_t>((sum.brightness[i] + frames / 2) / frames);
    sink.write_infrared(imager, light, mean,
                        {fine_steps_per_grey_level, sum.frames, metadata_.exposure_us, metadata_.gain,
                         metadata_.laser_power_mw});
  }
}

}  // namespace rva
