#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/json_object.hpp"
#include "inspect/review_measurement.hpp"
#include "server/api.hpp"
#include "server/measurement.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

ApiError no_pictures() {
  return {404, "not-found", "pictures", "do not exist", "see the rounds of the inspection"};
}

Eigen::Vector3d point_in(const Json& list) {
  Eigen::Vector3d point;
  constexpr double farthest_m = 1e3;
  const bool three = list.is_array() && list.size() == 3;
  for (std::size_t i = 0; i < 3; ++i) {
    const double number = three && list[i].is_number() ? list[i].get<double>() : 2.0 * farthest_m;
    if (!(std::abs(number) <= farthest_m))
      throw ApiError(400, "bad-request", "points_m", "is not a list of points", "see docs/api.md");
    point[static_cast<Eigen::Index>(i)] = number;
  }
  return point;
}

}  // namespace

// While the robot moves, frames show different scenes, and one alone is measured.
ApiResponse Api::measure_points(const Call& call) const {
  constexpr std::size_t most_frames = 8;
  const std::optional<Stream> stream = value_of<Stream>(text_field(call.body, "stream"));
  if (!stream)
    throw ApiError(400, "bad-request", "stream", "is none of color, depth, infrared", "see docs/api.md");
  const MeasureRequest request = measure_request_in(call.body);
  const DriveState robot = parts_.drive != nullptr ? parts_.drive->state() : DriveState{};
  const std::vector<std::shared_ptr<const LiveFrame>> frames =
      newest_frames(parts_.camera, robot.driving || robot.lent ? 1 : most_frames);
  Json answer = measure(measured_picture(frames, *stream, parts_.measure), request, parts_.measure);
  answer["frames"] = frames.size();
  return {200, "application/json", json_text(answer)};
}

// In the pictures of a comparison, which may be an earlier one.
ApiResponse Api::measure_view(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const std::optional<int> number = number_in_path(call.path_parts.at(1));
  const std::optional<int> view = number_in_path(call.path_parts.at(2));
  const std::optional<RecordedComparison> comparison =
      number ? parts_.inspector.comparison(id, *number) : std::nullopt;
  if (!comparison || !view) throw no_pictures();
  const std::optional<Side> side = value_of<Side>(text_field(call.body, "side"));
  if (!side) throw ApiError(400, "bad-request", "side", "is neither initial nor final", "see docs/api.md");
  const MeasureRequest request = measure_request_in(call.body);
  const MeasuredPicture picture =
      measured_review(parts_.inspector.folder(id), parts_.inspector.inspection(id), *comparison, *view, *side,
                      parts_.measure);
  return {200, "application/json", json_text(measure(picture, request, parts_.measure))};
}

ApiResponse Api::measure_map(const Call& call) const {
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  const auto list = call.body.find("points_m");
  if (list == call.body.end() || !list->is_array() || list->size() != 2)
    throw ApiError(400, "bad-request", "points_m", "is not a list of two points", "see docs/api.md");
  const MapMeasurement measured =
      measure_in_map(parts_.inspector.folder(inspection.id), inspection, parts_.inspector.chain(),
                     {point_in((*list)[0]), point_in((*list)[1])}, parts_.measure);
  return {200, "application/json", json_text(json_of(measured))};
}

}  // namespace rva
