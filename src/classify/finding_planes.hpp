// What a classifier of findings is shown: the surroundings of a finding in pictures and depth, at one size.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "capture/capture.hpp"
#include "detect/findings/detection.hpp"

namespace rva {

/// Rows and columns of each plane.
inline constexpr int plane_px = 48;

/// The planes, in the order in which a classifier takes them. Lengths that may be large in either direction
/// are x / (|x| + 20 mm); logarithms have base 10. Planes of one value have it in every pixel.
enum class FindingPlane {
  red,              ///< colour image, 0 to 1; the infrared image, relative to twice its mean, in darkness
  green,            ///< likewise
  blue,             ///< likewise
  color,            ///< 1 if the planes before are of a colour image, else 0
  infrared,         ///< 1 if they are of an infrared image, else 0
  change,           ///< by how much nearer the surface is than before; 0 where not measured twice
  change_measured,  ///< 1 where depth was measured before and after, else 0
  shape,            ///< how much nearer the surface is than the finding's median depth; 0 where not measured
  shape_measured,   ///< 1 where depth was measured after, else 0
  finding,          ///< 1 at the pixels of the finding, else 0
  scale,            ///< logarithm of the width of a pixel of the plane at the finding, mm
  long_side,        ///< logarithm of the longer side of the finding's box, cm
  short_side,       ///< logarithm of its shorter side, cm
  height,           ///< its height above the surface that it lies on; 0 where unknown
};

/// Number of planes.
inline constexpr int finding_planes = 14;

/// The picture of a capture by which findings are classified.
struct FindingPicture {
  ColorImage image;
  bool is_color = false;  ///< false: the left imager's infrared image under the projector, in grey
};

/// The first colour image, or where there is none, the infrared image.
/// @return empty where the capture has neither
/// @throws Error when an image is damaged
[[nodiscard]] std::optional<FindingPicture> picture_of(const Capture& final);

/// An infrared image under the projector, grey levels of 0 to 255, as a picture.
[[nodiscard]] FindingPicture picture_of(const Image<float>& infrared);

/// The planes of a finding. Pictures and depth are cut out as surroundings_of() states, each in its own
/// pixels, and scaled to plane_px.
/// @param final   description of the first final capture, in whose view the findings are
/// @param picture empty: the planes of the picture are 0
/// @return 14 x 48 x 48, float; empty where the finding was removed, so that nothing is there to be shown,
///         has no position, or lies outside the picture
[[nodiscard]] std::optional<cv::Mat> planes_of(const Finding& finding, const Detection& detection,
                                               const CaptureInfo& final,
                                               const std::optional<FindingPicture>& picture);

/// A finding with its planes.
struct ShownFinding {
  int finding = 0;  ///< id
  cv::Mat planes;   ///< as planes_of() returns them
};

/// What a classifier is shown of a comparison.
struct ShownFindings {
  std::string_view picture;            ///< "color", "infrared" or, with depth alone, "none"
  std::vector<ShownFinding> findings;  ///< those of which there are planes, in their order
};

/// The planes of all findings. @param final the first final capture, in whose view they are
/// @throws Error when an image is damaged
[[nodiscard]] ShownFindings shown_findings(const Detection& detection, const Capture& final);

/// The planes of several findings as a NumPy file of 16-bit floats, N x 14 x 48 x 48.
[[nodiscard]] std::string npy_of(const std::vector<cv::Mat>& planes);

/// The 16-bit floats of each finding in a file of npy_of(), as bytes of `file`.
/// @param source the file's name, for errors
/// @throws Error when it is no such file
[[nodiscard]] std::vector<std::span<const std::byte>> halves_in(std::span<const std::byte> file,
                                                                const std::string& source);

}  // namespace rva
