#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/date_time.hpp"
#include "core/json_object.hpp"
#include "inspect/review_measurement.hpp"
#include "server/api.hpp"
#include "server/measurement.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

Stream stream_in(const Json& body) {
  const std::optional<Stream> stream = value_of<Stream>(text_field(body, "stream"));
  if (!stream)
    throw ApiError(400, "bad-request", "stream", "is none of color, depth, infrared", "see docs/api.md");
  return *stream;
}

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
std::vector<std::shared_ptr<const LiveFrame>> Api::still_frames(
    std::shared_ptr<const LiveFrame> first) const {
  constexpr std::size_t most_frames = 8;
  const DriveState robot = parts_.drive != nullptr ? parts_.drive->state() : DriveState{};
  return frames_from(parts_.camera, std::move(first), robot.driving || robot.lent ? 1 : most_frames);
}

std::shared_ptr<const FrozenPicture> Api::frozen_in(const std::string& number) const {
  const std::optional<int> frozen = number_in_path(number);
  std::shared_ptr<const FrozenPicture> picture = frozen ? parts_.frozen->find(*frozen) : nullptr;
  if (!picture)
    throw ApiError(404, "not-found", "frozen picture", "is not kept any more",
                   "freeze the live picture again");
  return picture;
}

// In the live picture, or in one that was frozen.
ApiResponse Api::measure_points(const Call& call) const {
  const Stream stream = stream_in(call.body);
  const MeasureRequest request = measure_request_in(call.body);
  Json answer;
  if (call.body.contains("frozen")) {
    const auto frozen = frozen_in(std::to_string(std::llround(number_field(call.body, "frozen"))));
    if (!frozen->measured)
      throw Error("frozen picture", "has no depth that could be measured", "freeze the depth picture");
    answer = measure(*frozen->measured, request, parts_.measure);
    answer["frames"] = frozen->frames;
  } else {
    const auto frames = still_frames(newest_with(parts_.camera, Stream::depth));
    answer = measure(measured_picture(frames, stream, parts_.measure), request, parts_.measure);
    answer["frames"] = frames.size();
  }
  return {200, "application/json", json_text(answer)};
}

ApiResponse Api::freeze(const Call& call) const {
  const Stream stream = stream_in(call.body);
  const std::shared_ptr<const LiveFrame> live = newest_with(parts_.camera, stream);
  FrozenPicture frozen{stream, picture_of(*live, stream), std::nullopt, 0, iso_8601_now()};
  if (is_measurable(live->info, stream)) {
    const auto frames = still_frames(live);
    frozen.measured = measured_picture(frames, stream, parts_.measure);
    frozen.frames = frames.size();
  }
  Json answer{{"stream", name_of(stream)},
              {"width", frozen.picture.width()},
              {"height", frozen.picture.height()},
              {"taken_at", frozen.taken_at}};
  answer["frozen"] = parts_.frozen->add(std::move(frozen));
  return {201, "application/json", json_text(answer)};
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

// In the map of a comparison, by default of the valid one.
ApiResponse Api::measure_map(const Call& call) const {
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  const RecordedComparison comparison = comparison_of(call);
  const auto list = call.body.find("points_m");
  if (list == call.body.end() || !list->is_array() || list->size() != 2)
    throw ApiError(400, "bad-request", "points_m", "is not a list of two points", "see docs/api.md");
  const MapMeasurement measured =
      measure_in_map(parts_.inspector.folder(inspection.id), inspection, comparison, parts_.inspector.chain(),
                     {point_in((*list)[0]), point_in((*list)[1])}, parts_.measure);
  return {200, "application/json", json_text(json_of(measured))};
}

}  // namespace rva
