#include "server/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "capture/capture.hpp"
#include "core/units.hpp"
#include "measure/profile.hpp"
#include "measure/quantity.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

using Points = std::vector<PointOrReason>;

ApiError bad(const std::string& problem) {
  return {400, "bad-request", "measure", problem, "see docs/api.md"};
}

// What cannot be measured. The names are those of the API.
struct Unmeasurable {
  std::string part;                    // "point", "line-ends", "surface", "surface-points"
  std::string text;                    // for example "point 2"
  std::optional<std::size_t> point{};  // from 1
};

std::string problem_text(Unmeasured reason, const std::string& what) {
  switch (reason) {
    case Unmeasured::outside:
      return what + " is outside of the depth image";
    case Unmeasured::missing_depth:
      return "no depth is measured at " + what;
    case Unmeasured::edge:
      return what + " is at an edge between surfaces";
    case Unmeasured::collinear:
      return what + " span no plane: select points that are farther apart";
  }
  return {};
}

// States the first problem as a sentence, and as names for consoles in other languages.
void put_problem(Json& answer, Unmeasured reason, const Unmeasurable& what) {
  if (answer.contains("problem")) return;
  answer["problem"] = problem_text(reason, what.text);
  answer["unmeasured"] = {{"reason", name_of(reason)}, {"part", what.part}};
  if (what.point) answer["unmeasured"]["point"] = *what.point;
}

const SurfacePoint* measured(const PointOrReason& point) { return std::get_if<SurfacePoint>(&point); }

void put(Json& json, const std::string& name, const Quantity& quantity) {
  json[name + "_mm"] = quantity.value_mm;
  json[name + "_uncertainty_mm"] = quantity.expanded_mm();
}

Json json_of(const SurfacePoint& point, const Quantity& distance) {
  const Eigen::Vector3d& at_m = point.position_m;
  return {{"position_m", {at_m.x(), at_m.y(), at_m.z()}},
          {"distance_m", distance.value_mm / mm_per_m},
          {"distance_uncertainty_mm", distance.expanded_mm()},
          {"near_edge", point.near_edge}};
}

Json json_of(const PointOrReason& point, const MeasureOptions& options) {
  const SurfacePoint* found = measured(point);
  return found == nullptr ? Json(nullptr) : json_of(*found, distance_of(*found, options));
}

Json json_of(const ProfileSample& sample) {
  Json json{{"share", sample.share}};
  if (sample.point) {
    json["along_mm"] = sample.point->along_mm;
    put(json, "height", sample.point->height);
  }
  return json;
}

PlaneOrReason surface_of(const MeasuredPicture& picture, const MeasureRequest& request,
                         const Points& points) {
  if (request.surface) {
    const Box& box = *request.surface;
    return plane_in(picture.view,
                    picture.region({Eigen::Vector2d(box.x, box.y),
                                    Eigen::Vector2d(box.x + box.width - 1, box.y + box.height - 1)}));
  }
  return plane_through({*measured(points[0]), *measured(points[1]), *measured(points[2])});
}

void add_height(Json& answer, const MeasuredPicture& picture, const MeasureRequest& request,
                const Points& points, const MeasureOptions& options) {
  const PlaneOrReason plane = surface_of(picture, request, points);
  if (const auto* reason = std::get_if<Unmeasured>(&plane))
    put_problem(answer, *reason,
                request.surface ? Unmeasurable{"surface", "the surface"}
                                : Unmeasurable{"surface-points", "the three points of the surface"});
  else
    put(answer, "height", height_above(*measured(points.back()), std::get<Plane>(plane), options));
}

void add_profile(Json& answer, const MeasuredPicture& picture, const MeasureRequest& request,
                 const MeasureOptions& options) {
  const ProfileOrReason along = profile_along(picture.view, *picture.depth_pixel(request.points[0]),
                                              *picture.depth_pixel(request.points[1]), options);
  if (const auto* reason = std::get_if<Unmeasured>(&along)) {
    put_problem(answer, *reason, {"line-ends", "the ends of the line"});
    return;
  }
  answer["profile"] = Json::array();
  for (const ProfileSample& sample : std::get<Profile>(along).samples)
    answer["profile"].push_back(json_of(sample));
}

std::size_t points_of(MeasureTool tool, bool with_surface) {
  switch (tool) {
    case MeasureTool::distance:
      return 1;
    case MeasureTool::length:
    case MeasureTool::profile:
      return 2;
    case MeasureTool::height:
      return with_surface ? 1 : 4;
  }
  return 0;
}

}  // namespace

MeasureRequest measure_request_in(const Json& body) {
  constexpr std::size_t most_points = 4;
  const auto points = body.find("points");
  if (points == body.end() || !points->is_array() || points->empty() || points->size() > most_points)
    throw bad("needs one to four points");
  MeasureRequest request;
  for (const Json& point : *points)
    request.points.emplace_back(number_field(point, "u"), number_field(point, "v"));
  request.tool = request.points.size() == 1 ? MeasureTool::distance : MeasureTool::length;
  if (const std::string tool = text_field(body, "tool"); !tool.empty()) {
    const std::optional<MeasureTool> known = value_of<MeasureTool>(tool);
    if (!known) throw bad("has an unknown tool");
    request.tool = *known;
  }
  if (body.contains("bbox")) request.surface = box_field(body, "bbox");
  const std::size_t needed = points_of(request.tool, request.surface.has_value());
  if (request.points.size() != needed)
    throw bad(fmt::format("a {} needs {} point(s)", name_of(request.tool), needed));
  return request;
}

Json measure(const MeasuredPicture& picture, const MeasureRequest& request, const MeasureOptions& options) {
  Points points;
  Json answer{
      {"tool", name_of(request.tool)}, {"coverage_factor", coverage_factor}, {"points", Json::array()}};
  for (const Eigen::Vector2d& pixel : request.points) {
    points.push_back(picture.point(pixel, options));
    answer["points"].push_back(json_of(points.back(), options));
    const auto* reason = std::get_if<Unmeasured>(&points.back());
    if (reason != nullptr)
      put_problem(answer, *reason, {"point", fmt::format("point {}", points.size()), points.size()});
  }
  if (answer.contains("problem")) return answer;
  if (points.size() == 2)
    put(answer, "length", length_between(*measured(points[0]), *measured(points[1]), options));
  if (request.tool == MeasureTool::height) add_height(answer, picture, request, points, options);
  if (request.tool == MeasureTool::profile) add_profile(answer, picture, request, options);
  return answer;
}

Json json_of(const MapMeasurement& measured) {
  Json answer{{"tool", name_of(MeasureTool::length)},
              {"coverage_factor", coverage_factor},
              {"points", Json::array()}};
  for (const std::optional<MeasuredMapPoint>& found : measured.points) {
    answer["points"].push_back(found ? json_of(found->point, found->distance) : Json(nullptr));
    if (!found && !answer.contains("problem")) {
      const std::size_t point = answer["points"].size();
      answer["problem"] = fmt::format("no view measures point {}", point);
      answer["unmeasured"] = {{"reason", "no-view"}, {"part", "point"}, {"point", point}};
    }
  }
  if (measured.length) put(answer, "length", *measured.length);
  return answer;
}

bool is_measurable(const CaptureInfo& info, Stream stream) {
  return stream != Stream::color || (info.color && info.color_from_depth);
}

MeasuredPicture measured_picture(std::span<const std::shared_ptr<const LiveFrame>> frames, Stream stream,
                                 const MeasureOptions& options) {
  const CaptureInfo& info = frames.front()->info;
  if (!is_measurable(info, stream))
    throw Error("camera", "does not state from where its colour imager looks",
                "measure in the depth picture");
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (const std::shared_ptr<const LiveFrame>& live : frames) statistics.add(live->frame.depth);
  MeasuredPicture picture{uncertain_view(statistics, info.depth, stereo_scale(info), options), std::nullopt};
  if (stream == Stream::color) picture.picture = PictureCamera{*info.color, *info.color_from_depth};
  return picture;
}

std::shared_ptr<const LiveFrame> newest_with(const LiveCamera& camera, Stream stream) {
  constexpr int most_frames = 10;
  constexpr std::chrono::seconds patience{5};  // after which a camera counts as failed
  const auto end = std::chrono::steady_clock::now() + patience;
  std::shared_ptr<const LiveFrame> live = camera.newest();
  for (int i = 0; i < most_frames && live && !has_picture(*live, stream); ++i) {
    const auto left =
        std::max(end - std::chrono::steady_clock::now(), std::chrono::steady_clock::duration::zero());
    live = camera.wait_for_other(live.get(), std::chrono::duration_cast<std::chrono::milliseconds>(left));
  }
  if (!live) throw Error("camera", "delivers no frames", "wait a moment, then try again");
  return live;
}

std::vector<std::shared_ptr<const LiveFrame>> frames_from(const LiveCamera& camera,
                                                          std::shared_ptr<const LiveFrame> first,
                                                          std::size_t most) {
  constexpr std::chrono::milliseconds patience{400};
  const auto end = std::chrono::steady_clock::now() + patience;
  std::vector<std::shared_ptr<const LiveFrame>> frames{std::move(first)};
  const CaptureInfo& info = frames.front()->info;
  while (frames.size() < most) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    std::shared_ptr<const LiveFrame> next;
    if (left.count() > 0) next = camera.wait_for_other(frames.back().get(), left);
    if (!next || next->info.depth != info.depth || next->info.depth_unit_m != info.depth_unit_m) break;
    frames.push_back(std::move(next));
  }
  return frames;
}

}  // namespace rva
