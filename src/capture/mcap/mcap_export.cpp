#include "capture/mcap/mcap_export.hpp"

#include <fmt/format.h>

#include <optional>

#include "capture/mcap/mcap_capture_writer.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

bool has_means(const CaptureInfo& info) { return info.infrared && info.infrared->frames > 1; }

// Infrared images are means over all frames where the capture states so, else images of single frames.
void write_infrared(const Capture& capture, McapCaptureWriter& writer) {
  const CaptureInfo& info = capture.info();
  for (const Imager imager : both_imagers) {
    for (const Light light : {Light::projector, Light::lamp}) {
      const std::optional<InfraredBurst>& burst = light == Light::lamp ? info.lamp : info.infrared;
      if (!capture.has_infrared(imager, light) || (light == Light::projector && !has_means(info))) continue;
      InfraredBurst stored = burst.value_or(InfraredBurst{});
      stored.per_grey_level = fine_steps_per_grey_level;
      if (const auto mean = capture.infrared_mean(imager, light))
        writer.write_infrared(imager, light, fine_gray(*mean), stored);
    }
  }
}

// @return whether the frame has a colour image
bool write_frame(const Capture& capture, std::size_t number, McapCaptureWriter& writer) {
  writer.write_metadata(number, capture.metadata_of(number));
  writer.write_depth(number, capture.depth(number));
  const std::optional<ColorImage> color = capture.color_of(number);
  if (color) writer.write_color(number, *color);
  if (!has_means(capture.info())) {
    for (const auto& [imager, image] : infrared_of(capture, number))
      writer.write_infrared_of(number, imager, image);
  }
  return color.has_value();
}

}  // namespace

std::vector<std::string> write_mcap(const Capture& capture, const std::filesystem::path& file,
                                    const Progress& progress) {
  const CaptureInfo& info = capture.info();
  McapCaptureWriter writer(
      file, info, info.format == "rva-capture" && !info.source_json.empty() ? info.source_json : "{}");
  std::size_t with_color = 0;
  for (std::size_t number = 0; number < capture.depth_frames(); ++number) {
    throw_if_interrupted();
    with_color += write_frame(capture, number, writer) ? 1U : 0U;
    if (progress) progress("exporting", number + 1, capture.depth_frames());
  }
  write_infrared(capture, writer);
  writer.finish();
  if (with_color == capture.color_frames()) return {};
  return {fmt::format("{} colour image(s) that belong to no depth image were left out",
                      capture.color_frames() - with_color)};
}

}  // namespace rva
