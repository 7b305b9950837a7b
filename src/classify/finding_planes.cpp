#include "classify/finding_planes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "classify/surroundings.hpp"
#include "core/error.hpp"
#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "detect/findings/drawing.hpp"

namespace rva {
namespace {

constexpr float half_mm = 20.0F;  // a length that becomes 0.5

float bounded(float length_mm) { return length_mm / (std::abs(length_mm) + half_mm); }

constexpr std::size_t bytes_each = sizeof(std::uint16_t) * finding_planes * plane_px * plane_px;

// The beginning of a NumPy file with the planes of so many findings.
std::string npy_header(std::size_t findings) {
  std::string text = fmt::format("{{'descr': '<f2', 'fortran_order': False, 'shape': ({}, {}, {}, {}), }}",
                                 findings, finding_planes, plane_px, plane_px);
  const std::string magic("\x93NUMPY\x01\0", 8);
  constexpr std::size_t length_bytes = 2;
  constexpr std::size_t alignment = 64;
  while ((magic.size() + length_bytes + text.size() + 1) % alignment != 0) text += ' ';
  text += '\n';
  return magic + static_cast<char>(text.size() & 0xFFU) + static_cast<char>(text.size() >> 8U) + text;
}

// The planes of one finding while they are filled.
class Planes {
 public:
  Planes() : all_(std::vector<int>{finding_planes, plane_px, plane_px}, CV_32F, cv::Scalar(0)) {}

  [[nodiscard]] cv::Mat operator[](FindingPlane plane) {
    return {plane_px, plane_px, CV_32F, all_.ptr<float>(static_cast<int>(plane))};
  }
  [[nodiscard]] cv::Mat result() && { return std::move(all_); }

 private:
  cv::Mat all_;
};

cv::Mat scaled(const cv::Mat& part) {
  cv::Mat made;
  const bool shrinks = part.cols > plane_px || part.rows > plane_px;
  cv::resize(part, made, {plane_px, plane_px}, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return made;
}

void add_picture(const Box& box, const FindingPicture& picture, Planes& planes) {
  const Box part = surroundings_of(box, picture.image.width(), picture.image.height());
  const ColorImage cut = part_of(picture.image, part);
  cv::Mat values;
  as_mat(cut).convertTo(values, CV_32FC3, 1.0 / 255.0);
  if (!picture.is_color) {
    const double mean = cv::mean(values)[0];
    if (mean > 0.0) values /= 2.0 * mean;
    cv::min(values, cv::Scalar::all(1.0), values);
  }
  std::array<cv::Mat, 3> channels{planes[FindingPlane::red], planes[FindingPlane::green],
                                  planes[FindingPlane::blue]};
  cv::split(scaled(values), channels.data());
  planes[picture.is_color ? FindingPlane::color : FindingPlane::infrared] = 1.0;
}

// Sets the planes of depth at one of their pixels.
void add_depth(float before_m, float after_m, float middle_m, const cv::Point& at, Planes& planes) {
  constexpr float mm_per_m = 1000.0F;
  const auto set = [&](FindingPlane plane, float value) { planes[plane].at<float>(at) = value; };
  if (after_m <= 0.0F) return;
  set(FindingPlane::shape, bounded(mm_per_m * (middle_m - after_m)));
  set(FindingPlane::shape_measured, 1.0F);
  if (before_m <= 0.0F) return;
  set(FindingPlane::change, bounded(mm_per_m * (before_m - after_m)));
  set(FindingPlane::change_measured, 1.0F);
}

// The median depth of a finding, or where it has none, that of its position.
float middle_m_of(const Finding& finding, const Image<float>& after_m) {
  std::vector<float> depths_m;
  for (const std::uint32_t i : finding.pixels)
    if (after_m[i] > 0.0F) depths_m.push_back(after_m[i]);
  return depths_m.empty() ? static_cast<float>(finding.position_m->z()) : quantile(depths_m, 0.5);
}

// Depth images have gaps: each pixel of a plane is the nearest one of the image.
void add_depth(const Finding& finding, const Detection& detection, Planes& planes) {
  const Image<float>& before_m = detection.initial_m;
  const Image<float>& after_m = detection.final_m;
  const Box part = surroundings_of(finding.box, after_m.width(), after_m.height());
  const float middle_m = middle_m_of(finding, after_m);
  Mask own(after_m.width(), after_m.height());
  for (const std::uint32_t i : finding.pixels) own[i] = 1;
  for (int row = 0; row < plane_px; ++row) {
    for (int column = 0; column < plane_px; ++column) {
      const int u = part.x + (2 * column + 1) * part.width / (2 * plane_px);
      const int v = part.y + (2 * row + 1) * part.height / (2 * plane_px);
      add_depth(before_m(u, v), after_m(u, v), middle_m, {column, row}, planes);
      planes[FindingPlane::finding].at<float>(row, column) = own(u, v) != 0 ? 1.0F : 0.0F;
    }
  }
}

void add_sizes(const Finding& finding, const CaptureInfo& final, const Detection& detection, Planes& planes) {
  const auto [least_mm, most_mm] = std::minmax((*finding.size_mm)[0], (*finding.size_mm)[1]);
  const Box part = surroundings_of(finding.box, detection.final_m.width(), detection.final_m.height());
  const double pixel_mm = 1000.0 * finding.position_m->z() / final.depth.fx * part.width / plane_px;
  constexpr double mm_per_cm = 10.0;
  constexpr double smallest_mm = 0.1;
  planes[FindingPlane::scale] = std::log10(std::max(pixel_mm, smallest_mm));
  planes[FindingPlane::long_side] = std::log10(std::max(most_mm, smallest_mm) / mm_per_cm);
  planes[FindingPlane::short_side] = std::log10(std::max(least_mm, smallest_mm) / mm_per_cm);
  const auto height_mm =
      finding.top_above_surroundings_mm ? finding.top_above_surroundings_mm : finding.above_surroundings_mm;
  planes[FindingPlane::height] = bounded(static_cast<float>(height_mm.value_or(0.0)));
}

}  // namespace

std::optional<FindingPicture> picture_of(const Capture& final) {
  if (final.color_frames() > 0) return FindingPicture{final.color(0), true};
  const auto infrared = final.infrared_mean(Imager::left, Light::projector);
  if (!infrared) return std::nullopt;
  return picture_of(*infrared);
}

FindingPicture picture_of(const Image<float>& infrared) {
  ColorImage picture(infrared.width(), infrared.height());
  constexpr float white = 255.0F;
  for (std::size_t i = 0; i < infrared.size(); ++i) {
    const auto level = static_cast<std::uint8_t>(std::lround(std::clamp(infrared[i], 0.0F, white)));
    picture[i] = {level, level, level};
  }
  return {std::move(picture), false};
}

std::optional<cv::Mat> planes_of(const Finding& finding, const Detection& detection, const CaptureInfo& final,
                                 const std::optional<FindingPicture>& picture) {
  if (finding.kind == ChangeKind::removed || !finding.position_m || !finding.size_mm) return std::nullopt;
  Planes planes;
  if (picture) {
    const auto box =
        picture->is_color ? box_on_color(finding, detection.final_m, final, picture->image) : finding.box;
    if (!box) return std::nullopt;
    add_picture(*box, *picture, planes);
  }
  add_depth(finding, detection, planes);
  add_sizes(finding, final, detection, planes);
  return std::move(planes).result();
}

ShownFindings shown_findings(const Detection& detection, const Capture& final) {
  const std::optional<FindingPicture> picture = picture_of(final);
  ShownFindings shown{"none", {}};
  if (picture) shown.picture = picture->is_color ? "color" : "infrared";
  for (const Finding& finding : detection.findings.findings)
    if (auto planes = planes_of(finding, detection, final.info(), picture))
      shown.findings.push_back({finding.id, *std::move(planes)});
  return shown;
}

// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
std::string npy_of(const std::vector<cv::Mat>& planes) {
  std::string file = npy_header(planes.size());
  for (const cv::Mat& one : planes) {
    cv::Mat half;
    one.convertTo(half, CV_16F);
    file.append(reinterpret_cast<const char*>(half.data), bytes_each);
  }
  return file;
}

std::vector<std::span<const std::byte>> halves_in(std::span<const std::byte> file,
                                                  const std::string& source) {
  const std::size_t count = file.size() / bytes_each;  // the header is much shorter than one of them
  const std::string header = npy_header(count);
  if (file.size() != header.size() + count * bytes_each ||
      std::memcmp(file.data(), header.data(), header.size()) != 0)
    throw Error(source, "is damaged, or of another version", "compare the inspection again");
  std::vector<std::span<const std::byte>> halves;
  for (std::size_t i = 0; i < count; ++i)
    halves.push_back(file.subspan(header.size() + i * bytes_each, bytes_each));
  return halves;
}

}  // namespace rva
