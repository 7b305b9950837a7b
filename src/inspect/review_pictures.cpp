#include "inspect/review_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "core/quantile.hpp"
#include "depth/colorize.hpp"
#include "depth/image_file.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

float median_m(const Image<float>& depth_m) {
  std::vector<float> measured;
  std::ranges::copy_if(depth_m.pixels(), std::back_inserter(measured), [](float m) { return m > 0.0F; });
  return measured.empty() ? 1.0F : quantile(measured, 0.5);
}

/// The coordinates in an image of each pixel of a view, in the form that OpenCV's remap() takes.
struct PixelMap {
  Image<float> u;
  Image<float> v;
};

PixelMap map_to(const Intrinsics& camera, const Transform& camera_from_view, const Intrinsics& view,
                const Image<float>& view_depth_m) {
  constexpr float outside = -10.0F;
  PixelMap map{{view.width, view.height, outside}, {view.width, view.height, outside}};
  const float usual_m = median_m(view_depth_m);
  parallel_bands(view.height, [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const float measured_m = view_depth_m(u, v);
        const Eigen::Vector3d point =
            camera_from_view * view.deproject({u, v}, measured_m > 0.0F ? measured_m : usual_m);
        if (point.z() <= 0.0) continue;
        const Eigen::Vector2d pixel = camera.project(point);
        map.u(u, v) = static_cast<float>(pixel.x());
        map.v(u, v) = static_cast<float>(pixel.y());
      }
    }
  });
  return map;
}

template <typename Pixels>
Pixels sample(const Pixels& image, const PixelMap& map, int interpolation) {
  Pixels seen(map.u.width(), map.u.height());
  cv::remap(as_mat(image), as_mat(seen), as_mat(map.u), as_mat(map.v), interpolation, cv::BORDER_CONSTANT);
  return seen;
}

// The colour imager's view is smaller than the depth imager's. Pixels beyond it become grey, the farther the
// darker.
void shade_beyond(ColorImage& seen, const Image<float>& depth_m) {
  const float usual_m = median_m(depth_m);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != Rgb{} || depth_m[i] <= 0.0F) continue;
    const auto level = static_cast<std::uint8_t>(std::clamp(70.0F * usual_m / depth_m[i], 0.0F, 110.0F));
    seen[i] = {level, level, level};
  }
}

// The last colour image, taken when the light had settled. Empty if it cannot be read: depth is compared all
// the same.
ColorImage last_color(const Capture& capture) {
  if (capture.color_frames() == 0) return {};
  try {
    return capture.color(capture.color_frames() - 1);
  } catch (const Error&) {
    return {};
  }
}

ColorImage color_in_view(const Capture& capture, const Transform& depth_from_view, const Intrinsics& view,
                         const Image<float>& view_depth_m) {
  const CaptureInfo& info = capture.info();
  const ColorImage color = last_color(capture);
  if (color.empty()) return {};
  const Intrinsics camera = info.color.value_or(info.depth);
  if (camera.width != color.width() || camera.height != color.height()) return {};
  const Transform color_from_depth = info.color_from_depth.value_or(Transform::Identity());
  ColorImage seen = seen_from(color, camera, color_from_depth * depth_from_view, view, view_depth_m);
  shade_beyond(seen, view_depth_m);
  return seen;
}

Image<float> metres(const Capture& capture) {
  const DepthImage depth = capture.depth(capture.depth_frames() - 1);
  Image<float> result(depth.width(), depth.height());
  const auto unit_m = static_cast<float>(capture.info().depth_unit_m);
  std::ranges::transform(depth.pixels(), result.pixels().begin(),
                         [&](std::uint16_t units) { return static_cast<float>(units) * unit_m; });
  return result;
}

ColorImage colorized(Image<float> depth_m, ColorScale scale) {
  for (float& m : depth_m.pixels()) {
    if (m <= 0.0F) m = std::numeric_limits<float>::quiet_NaN();
  }
  return colorize(depth_m, scale);
}

ColorScale scale_of(Image<float> depth_m) {
  for (float& m : depth_m.pixels()) {
    if (m <= 0.0F) m = std::numeric_limits<float>::quiet_NaN();
  }
  return scale_of_depth(depth_m);
}

Rgb color_of(ChangeKind kind, std::uint8_t level) {
  const auto part = [level](int of) { return static_cast<std::uint8_t>(level / of); };
  switch (kind) {
    case ChangeKind::added:
      return {level, part(3), 0};
    case ChangeKind::removed:
      return {0, part(2), level};
    case ChangeKind::appearance:
      break;
  }
  return {part(2), level, part(3)};
}

// The changes as a picture that is added to another one: the greater the height, the brighter. A finding
// where depth was lost has no height and is drawn at full brightness.
ColorImage draw_changed(const Detection& detection) {
  constexpr double strong_mm = 20.0;
  constexpr double least = 0.45;
  ColorImage picture(detection.changed.width(), detection.changed.height());
  for (const Finding& finding : detection.findings.findings) {
    const double share = std::clamp(std::abs(finding.height_mm.value_or(strong_mm)) / strong_mm, 0.0, 1.0);
    const auto level = static_cast<std::uint8_t>(255.0 * (least + (1.0 - least) * share));
    const Rgb color = color_of(finding.kind, level);
    for (const std::uint32_t pixel : finding.pixels) picture[pixel] = color;
  }
  return picture;
}

// Striped, so that the marking does not depend on colour alone.
ColorImage draw_not_inspected(const Detection& detection) {
  constexpr int period_px = 10;
  constexpr Rgb bright{230, 60, 200};
  constexpr Rgb dim{70, 15, 60};
  ColorImage picture(detection.final_m.width(), detection.final_m.height());
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const bool judged = detection.level_of_detection
                              ? std::isfinite(detection.level_of_detection->least_mm(u, v))
                              : detection.final_m(u, v) > 0.0F;
      if (!judged) picture(u, v) = (u + v) % period_px < period_px / 2 ? bright : dim;
    }
  }
  return picture;
}

// Dotted, so that the marking differs from the stripes of what was not inspected by more than its colour.
ColorImage draw_dotted(const Mask& mask) {
  constexpr int period_px = 8;
  constexpr int dot_px = 3;
  constexpr Rgb bright{60, 230, 150};
  constexpr Rgb dim{10, 60, 40};
  ColorImage picture(mask.width(), mask.height());
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const bool dot = u % period_px < dot_px && v % period_px < dot_px;
      if (mask(u, v) != 0) picture(u, v) = dot ? bright : dim;
    }
  }
  return picture;
}

void draw_findable(const Detection& detection, const Intrinsics& view, ReviewPictures& pictures) {
  if (!detection.level_of_detection) return;
  const LevelOfDetection& level = *detection.level_of_detection;
  for (std::size_t k = 0; k < findable_sizes_mm.size(); ++k)
    pictures.findable[k] = draw_dotted(findable_mask(level.least_mm, detection.final_m,
                                                     level.summary.window_px, view.fx, findable_sizes_mm[k]));
}

struct PictureFile {
  std::string_view name;
  ColorImage ReviewPictures::*picture;
};

constexpr std::array picture_files{PictureFile{"initial_color.png", &ReviewPictures::initial_color},
                                   PictureFile{"final_color.png", &ReviewPictures::final_color},
                                   PictureFile{"initial_depth.png", &ReviewPictures::initial_depth},
                                   PictureFile{"final_depth.png", &ReviewPictures::final_depth},
                                   PictureFile{"changed.png", &ReviewPictures::changed},
                                   PictureFile{"not_inspected.png", &ReviewPictures::not_inspected}};

std::string findable_file(double size_mm) { return fmt::format("findable_{:g}mm.png", size_mm); }

}  // namespace

ColorImage seen_from(const ColorImage& image, const Intrinsics& camera, const Transform& camera_from_view,
                     const Intrinsics& view, const Image<float>& view_depth_m) {
  return sample(image, map_to(camera, camera_from_view, view, view_depth_m), cv::INTER_LINEAR);
}

ColorImage draw_depth(const Capture& capture) {
  const Image<float> depth_m = metres(capture);
  return colorized(depth_m, scale_of(depth_m));
}

ColorImage draw_color(const Capture& capture) {
  return color_in_view(capture, Transform::Identity(), capture.info().depth, metres(capture));
}

std::vector<std::string> review_picture_files() {
  std::vector<std::string> names;
  for (const PictureFile& file : picture_files) names.emplace_back(file.name);
  for (const double size_mm : findable_sizes_mm) names.push_back(findable_file(size_mm));
  return names;
}

void write_review(const ReviewPictures& pictures, const std::filesystem::path& folder) {
  for (const PictureFile& file : picture_files) {
    const ColorImage& picture = pictures.*file.picture;
    if (!picture.empty()) write_file(folder / file.name, encode_png(picture));
  }
  for (std::size_t k = 0; k < pictures.findable.size(); ++k) {
    if (pictures.findable[k].empty()) continue;
    write_file(folder / findable_file(findable_sizes_mm[k]), encode_png(pictures.findable[k]));
  }
}

ReviewPictures draw_review(const Capture& initial, const Capture& final, const Detection& detection) {
  const Intrinsics& view = final.info().depth;
  const Transform initial_from_final = detection.findings.final_from_initial.inverse();
  const ColorScale scale = scale_of(detection.final_m);
  ReviewPictures pictures;
  pictures.initial_color = color_in_view(initial, initial_from_final, view, detection.final_m);
  pictures.final_color = color_in_view(final, Transform::Identity(), view, detection.final_m);
  pictures.initial_depth = colorized(
      sample(metres(initial), map_to(initial.info().depth, initial_from_final, view, detection.final_m),
             cv::INTER_NEAREST),
      scale);
  pictures.final_depth = colorized(detection.final_m, scale);
  pictures.changed = draw_changed(detection);
  pictures.not_inspected = draw_not_inspected(detection);
  draw_findable(detection, view, pictures);
  return pictures;
}

}  // namespace rva
