#include "camera/noise_files.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/colorize.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const NoiseBin& bin) {
  Json json{{"from_m", bin.from_m}, {"to_m", bin.to_m}, {"pixels", bin.pixels}};
  if (bin.pixels == 0) return json;
  json["median_std_mm"] = bin.median_std_mm;
  json["p95_std_mm"] = bin.p95_std_mm;
  if (bin.subpixel_rms_px) json["subpixel_rms_px"] = *bin.subpixel_rms_px;
  return json;
}

}  // namespace

std::vector<std::string> noise_files() { return {"noise.json", "std.png", "drift.png"}; }

nlohmann::ordered_json json_of(const NoiseReport& report) {
  Json json{{"format", "rva-noise"},
            {"version", 1},
            {"frames", report.frames},
            {"fill_rate", report.fill_rate},
            {"overall", json_of(report.overall)}};
  json["by_distance"] = Json::array();
  for (const NoiseBin& bin : report.bins) json["by_distance"].push_back(json_of(bin));
  json["welch"] = {
      {"frames", report.welch_frames}, {"alpha", report.alpha}, {"tested_px", report.welch_tested_px}};
  if (report.welch_tested_px > 0) json["welch"]["rejected"] = report.welch_rejected;
  return json;
}

GrayImage drift_picture(const Noise& noise) {
  constexpr std::uint8_t untested = 96;
  GrayImage picture(noise.welch_p.width(), noise.welch_p.height());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const float p = noise.welch_p[i];
    const bool rejected = static_cast<double>(p) < noise.report.alpha;
    picture[i] = std::isnan(p) ? untested : rejected ? mask_set : std::uint8_t{0};
  }
  return picture;
}

void write_noise(const Noise& noise, const OutputFolder& out) {
  const ColorScale scale = scale_from_zero(noise.std_mm);
  // The colours of the thesis' figure 3.5, which this picture repeats.
  write_file(out.path("std.png"), encode_png(with_legend(colorize(noise.std_mm, scale, ColorMap::jet), scale,
                                                         "deviation\nover time\n(mm)", ColorMap::jet)));
  write_file(out.path("drift.png"), encode_png(drift_picture(noise)));
  write_file(out.path("noise.json"), json_file_text(json_of(noise.report)));
}

}  // namespace rva
