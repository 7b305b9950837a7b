// Measuring at points that a person selects in a picture: the request, and its answer.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "camera/live_camera.hpp"
#include "core/enum_names.hpp"
#include "inspect/review_measurement.hpp"
#include "measure/measured_picture.hpp"
#include "server/json_of.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// What is measured.
enum class MeasureTool { distance, length, height, profile };
template <>
inline constexpr auto enum_names<MeasureTool> = std::to_array<EnumName<MeasureTool>>({
    {MeasureTool::distance, "distance"},
    {MeasureTool::length, "length"},
    {MeasureTool::height, "height"},
    {MeasureTool::profile, "profile"},
});

/// A request to measure.
struct MeasureRequest {
  MeasureTool tool = MeasureTool::distance;
  /// In pixels of the picture. A distance has one; a length and a profile have two; a height has three of the
  /// surface and one above it, or only the last where there is a `surface`.
  std::vector<Eigen::Vector2d> points;
  std::optional<Box> surface;  ///< region of the plane of a height, in pixels of the picture
};

/// @param body with `points`, and optionally `tool` (by default a distance of one point and a length of two)
///             and `bbox`, the surface
/// @throws ApiError (400) when it is malformed, or the number of points does not fit the tool
[[nodiscard]] MeasureRequest measure_request_in(const Json& body);

/// The answer, `Measurement` of docs/api.md. Where something cannot be measured, it states why.
[[nodiscard]] Json measure(const MeasuredPicture& picture, const MeasureRequest& request,
                           const MeasureOptions& options);

/// The answer for two points of a map, likewise.
[[nodiscard]] Json json_of(const MapMeasurement& measured);

/// Whether points of a stream's picture can be measured: in colour, only where the camera states from where
/// the colour imager looks.
[[nodiscard]] bool is_measurable(const CaptureInfo& info, Stream stream);

/// A stream's picture of live frames.
/// @param frames one or more of a scene in which nothing moved, of one size
/// @throws Error when is_measurable() is false
[[nodiscard]] MeasuredPicture measured_picture(std::span<const std::shared_ptr<const LiveFrame>> frames,
                                               Stream stream, const MeasureOptions& options);

/// The newest frame with an image of a stream, which not every frame of a camera needs to have.
/// @throws Error when there is no frame
[[nodiscard]] std::shared_ptr<const LiveFrame> newest_with(const LiveCamera& camera, Stream stream);

/// A frame and those that follow within a moment, as long as they are of the same camera.
/// @param first not null
/// @param most  number of frames at most
[[nodiscard]] std::vector<std::shared_ptr<const LiveFrame>> frames_from(
    const LiveCamera& camera, std::shared_ptr<const LiveFrame> first, std::size_t most);

}  // namespace rva
