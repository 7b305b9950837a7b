#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "core/date_time.hpp"
#include "core/file_origin.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"
#include "report/inspection_report.hpp"
#include "report/pdf/pdf_report.hpp"
#include "server/api.hpp"
#include "server/live_pictures.hpp"
#include "server/measurement.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

int finding_number(const std::string& text) {
  const std::optional<int> number = number_in_path(text);
  if (!number)
    throw ApiError(404, "not-found", "finding", printable(text) + " is not a number",
                   "see the list of findings");
  return *number;
}

// The number of the comparison that a request refers to, by its number or, from older consoles, by its time.
// 0 if it is none.
int comparison_in(const Json& body, const Inspection& inspection) {
  if (body.contains("comparison")) return std::max(0, count_field(body, "comparison"));
  const std::string compared_at = text_field(body, "compared_at");
  const bool same = inspection.comparison && inspection.comparison->compared_at == compared_at;
  return same ? inspection.comparison->number : 0;
}

Decision decision_in(const Json& body, const std::string& person) {
  const std::optional<Verdict> verdict = value_of<Verdict>(text_field(body, "verdict"));
  if (!verdict)
    throw ApiError(
        400, "bad-request", "verdict", "is missing or unknown",
        "give debris, debris-removed, debris-unreachable, installed-work, false-alarm, second-look "
        "or undecided");
  return {.verdict = *verdict,
          .note = text_field(body, "note", most_note_bytes),
          .person = person,
          .decided_at = iso_8601_now(),
          .round = 0,
          .object = text_field(body, "object")};
}

// A decision that names its finding, or its marked finding.
FindingDecision finding_decision_in(const Json& item, const std::string& person) {
  if (!item.is_object() || item.contains("finding") == item.contains("mark"))
    throw ApiError(400, "bad-request", "decisions", "contains one without a finding or a mark",
                   "see docs/api.md");
  const bool marked = item.contains("mark");
  return {count_field(item, marked ? "mark" : "finding"), marked, decision_in(item, person)};
}

std::vector<FindingDecision> decisions_in(const Json& body, const std::string& person) {
  const auto given = body.find("decisions");
  if (given == body.end() || !given->is_array())
    throw ApiError(400, "bad-request", "decisions", "is not a list of decisions", "see docs/api.md");
  std::vector<FindingDecision> decisions;
  for (const Json& item : *given) decisions.push_back(finding_decision_in(item, person));
  return decisions;
}

// A mark in a live picture, with the position of what it shows.
MarkedFinding located(const std::shared_ptr<const LiveFrame>& live, Stream stream, const Box& box,
                      const MeasureOptions& options) {
  MarkedFinding marked;
  marked.box = box;
  const CaptureInfo& info = live->info;
  if (!is_measurable(info, stream)) return marked;
  const PointOrReason found =
      measured_picture({&live, 1}, stream, options)
          .point({box.x + (box.width - 1) / 2.0, box.y + (box.height - 1) / 2.0}, options);
  const auto* point = std::get_if<SurfacePoint>(&found);
  if (point == nullptr) return marked;
  marked.position_m = point->position_m;
  const Intrinsics& camera = stream == Stream::color ? info.color.value_or(info.depth) : info.depth;
  const double depth_mm = mm_per_m * point->position_m.z();
  marked.size_mm = {box.width * depth_mm / camera.fx, box.height * depth_mm / camera.fy};
  return marked;
}

}  // namespace

ApiResponse Api::get_rounds(const Call& call) const {
  Json rounds = Json::array();
  for (const ComparedRound& round : parts_.inspector.rounds(inspection_id(call)))
    rounds.push_back(json_of(round));
  return {200, "application/json", json_text(Json{{"rounds", rounds}})};
}

// The document embeds its pictures and runs nothing; the policy of the console would forbid its style.
ApiResponse Api::get_report(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  return {
      200,
      "text/html; charset=utf-8",
      inspection_report(parts_.inspector.history(id), parts_.inspector.folder(id), time_of_making()),
      {{"Content-Security-Policy",
        "sandbox; default-src 'none'; img-src data:; style-src 'unsafe-inline'; frame-ancestors 'none'"}}};
}

ApiResponse Api::get_pdf_report(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  return {200,
          "application/pdf",
          pdf_report(report_on(parts_.inspector.history(id), parts_.inspector.folder(id)), Paper::a4),
          {{"Content-Disposition", fmt::format("inline; filename=\"inspection-{}.pdf\"", id)}}};
}

ApiResponse Api::decide(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const int number = finding_number(call.path_parts.at(1));
  parts_.inspector.decide(id, comparison_in(call.body, parts_.inspector.inspection(id)), number,
                          decision_in(call.body, person_of(call)));
  return whole_inspection(id);
}

ApiResponse Api::decide_mark(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.decide_mark(id, finding_number(call.path_parts.at(1)),
                               decision_in(call.body, person_of(call)));
  return whole_inspection(id);
}

// On all of the findings, or on none.
ApiResponse Api::decide_all(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.decide_all(id, std::max(0, count_field(call.body, "comparison")),
                              decisions_in(call.body, person_of(call)));
  return whole_inspection(id);
}

// In the pictures of a view, or, if the request names a stream, in the newest live picture.
ApiResponse Api::mark(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const Box box = box_field(call.body, "bbox");
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
  parts_.inspector.mark_in_picture(id, located(live, *stream, box, parts_.measure),
                                   picture_of(*live, *stream), remark);
  return whole_inspection(id, 201);
}

// Keeps the picture that the request names as frozen, or else the newest live one.
ApiResponse Api::keep_snapshot(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const Remark remark{text_field(call.body, "note", most_note_bytes), person_of(call)};
  if (call.body.contains("frozen")) {
    const auto frozen = frozen_in(std::to_string(count_field(call.body, "frozen")));
    parts_.inspector.keep_snapshot(id, frozen->picture, remark);
    return whole_inspection(id, 201);
  }
  const std::optional<Stream> stream = value_of<Stream>(text_field(call.body, "stream"));
  if (!stream)
    throw ApiError(400, "bad-request", "stream", "is none of color, depth, infrared", "see docs/api.md");
  const std::shared_ptr<const LiveFrame> live = newest_with(parts_.camera, *stream);
  parts_.inspector.keep_snapshot(id, picture_of(*live, *stream), remark);
  return whole_inspection(id, 201);
}

ApiResponse Api::close(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  parts_.inspector.close(id, count_field(call.body, "comparison"),
                         {text_field(call.body, "note", most_note_bytes), person_of(call)});
  return whole_inspection(id);
}

}  // namespace rva
