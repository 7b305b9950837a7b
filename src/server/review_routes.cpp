#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/date_time.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"
#include "server/api.hpp"
#include "server/live_pictures.hpp"
#include "server/measurement.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

constexpr double most_number = 1e9;

int number_in_path(const std::string& text) {
  int number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size())
    throw ApiError(404, "not-found", "finding", printable(text) + " is not a number",
                   "see the list of findings");
  return number;
}

// A whole number from 0; -1 if the field has another number.
int count_field(const Json& body, const char* key) {
  const double number = number_field(body, key);
  return number >= 0.0 && number <= most_number && number == std::floor(number) ? static_cast<int>(number)
                                                                                : -1;
}

// The number of the comparison that a request refers to, by its number or, from older consoles, by its time.
// 0 if it is none.
int comparison_in(const Json& body, const Inspection& inspection) {
  if (body.contains("comparison")) return std::max(0, count_field(body, "comparison"));
  const std::string compared_at = text_field(body, "compared_at");
  const bool same = inspection.comparison && inspection.comparison->compared_at == compared_at;
  return same ? inspection.comparison->number : 0;
}

Box box_in(const Json& body) {
  const auto found = body.find("bbox");
  std::array<int, 4> sides{};
  const bool is_list = found != body.end() && found->is_array() && found->size() == sides.size();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double side = is_list && (*found)[i].is_number() ? (*found)[i].get<double>() : -1.0;
    if (!(side >= 0.0 && side <= most_number))
      throw ApiError(400, "bad-request", "bbox", "is not a list of four numbers from 0", "see docs/api.md");
    sides[i] = static_cast<int>(side);
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

// A mark in a live picture, with the position of what it shows.
MarkedFinding located(const LiveFrame& live, Stream stream, const Box& box) {
  MarkedFinding marked;
  marked.box = box;
  const std::optional<MeasuredPoint> point =
      measure(live, stream, {box.x + (box.width - 1) / 2.0, box.y + (box.height - 1) / 2.0});
  if (!point) return marked;
  marked.position_m = point->position_m;
  const Intrinsics& camera =
      stream == Stream::color ? live.info.color.value_or(live.info.depth) : live.info.depth;
  const double depth_mm = mm_per_m * point->position_m.z();
  marked.size_mm = {box.width * depth_mm / camera.fx, box.height * depth_mm / camera.fy};
  return marked;
}

// The newest frame with an image of this stream, which not every frame of a camera needs to have.
std::shared_ptr<const LiveFrame> newest_with(const LiveCamera& camera, Stream stream) {
  constexpr int most_frames = 10;
  constexpr std::chrono::milliseconds patience{500};
  std::shared_ptr<const LiveFrame> live = camera.newest();
  for (int i = 0; i < most_frames && live && !has_picture(*live, stream); ++i)
    live = camera.wait_for_other(live.get(), patience);
  if (!live) throw Error("camera", "delivers no frames", "wait a moment, then try again");
  return live;
}

}  // namespace

ApiResponse Api::get_rounds(const Call& call) const {
  Json rounds = Json::array();
  for (const ComparedRound& round : parts_.inspector.rounds(inspection_id(call)))
    rounds.push_back(json_of(round));
  return {200, "application/json", json_text(Json{{"rounds", rounds}})};
}

ApiResponse Api::decide(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const int number = number_in_path(call.path_parts.at(1));
  parts_.inspector.decide(id, comparison_in(call.body, parts_.inspector.inspection(id)), number,
                          decision_in(call));
  return whole_inspection(id);
}

ApiResponse Api::decide_mark(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.decide_mark(id, number_in_path(call.path_parts.at(1)), decision_in(call));
  return whole_inspection(id);
}

Decision Api::decision_in(const Call& call) {
  const std::optional<Verdict> verdict = value_of<Verdict>(text_field(call.body, "verdict"));
  if (!verdict)
    throw ApiError(
        400, "bad-request", "verdict", "is missing or unknown",
        "give debris, debris-removed, debris-unreachable, installed-work, false-alarm or second-look");
  return {*verdict, text_field(call.body, "note", most_note_bytes), person_of(call), iso_8601_now()};
}

// In the pictures of a view, or, if the request names a stream, in the newest live picture.
ApiResponse Api::mark(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const Box box = box_in(call.body);
  const Remark remark{text_field(call.body, "note", most_note_bytes), person_of(call)};
  if (!call.body.contains("stream")) {
    parts_.inspector.mark(id, count_field(call.body, "comparison"), count_field(call.body, "view"), box,
                          remark);
    return whole_inspection(id, 201);
  }
  const std::optional<Stream> stream = value_of<Stream>(text_field(call.body, "stream"));
  if (!stream)
    throw ApiError(400, "bad-request", "stream", "is none of color, depth, infrared", "see docs/api.md");
  const std::shared_ptr<const LiveFrame> live = newest_with(parts_.camera, *stream);
  parts_.inspector.mark_in_picture(id, located(*live, *stream, box), picture_of(*live, *stream), remark);
  return whole_inspection(id, 201);
}

ApiResponse Api::close(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.close(id, count_field(call.body, "comparison"),
                         {text_field(call.body, "note", most_note_bytes), person_of(call)});
  return whole_inspection(id);
}

}  // namespace rva
