#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "capture/capture.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/image_file.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/result_folder.hpp"
#include "inspect/review_pictures.hpp"
#include "map/view_capture.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

// Whether a picture of a view's result may be requested: those of the review, and two of the detection.
bool is_picture(std::string_view name) {
  const std::vector<std::string> review = review_picture_files();
  return std::ranges::find(review, name) != review.end() || name == result_file::level_picture ||
         name == result_file::changes;
}

ApiError not_there() { return {404, "not-found", "picture", "does not exist", "take both captures first"}; }

ApiError no_map() {
  return {404, "not-found", "map", "does not exist", "see the pictures of the inspection"};
}

int view_number(const std::string& text) {
  const std::optional<int> view = number_in_path(text);
  if (!view) throw not_there();
  return *view;
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Browsers do not cache the file (http_response()), since it would outlive a sign-out. Links are refused,
// since they could lead to any file of this computer.
ApiResponse file_answer(const InspectionFolder& folder, const std::filesystem::path& path,
                        const std::string& content_type, const ApiError& missing = not_there()) {
  std::error_code ignored;
  if (path.empty() || !std::filesystem::is_regular_file(std::filesystem::symlink_status(path, ignored)))
    throw ApiError(missing);
  folder.require_no_links(path.parent_path());
  return {200, content_type, text_of(read_file(path))};
}

}  // namespace

ApiResponse Api::get_picture(const Call& call) const {
  const std::string& name = call.path_parts.at(2);
  const int view = view_number(call.path_parts.at(1));
  if (!is_picture(name)) throw not_there();
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  if (!inspection.comparison) throw not_there();
  const InspectionFolder folder = parts_.inspector.folder(inspection.id);
  return file_answer(folder, folder.result(inspection, view) / name, "image/png");
}

ApiResponse Api::get_round_picture(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const int number = view_number(call.path_parts.at(1));
  const int view = view_number(call.path_parts.at(2));
  const std::string& name = call.path_parts.at(3);
  if (!is_picture(name)) throw not_there();
  const std::optional<RecordedComparison> comparison = parts_.inspector.comparison(id, number);
  if (!comparison) throw not_there();
  const InspectionFolder folder = parts_.inspector.folder(id);
  return file_answer(folder, InspectionFolder::result_in(folder.path() / comparison->folder, view) / name,
                     "image/png");
}

ApiResponse Api::get_marked_picture(const Call& call) const {
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  const int number = view_number(call.path_parts.at(1));
  const InspectionFolder folder = parts_.inspector.folder(inspection.id);
  for (const MarkedFinding& marked : inspection.marked) {
    if (marked.number == number) return file_answer(folder, folder.path() / marked.picture, "image/png");
  }
  throw not_there();
}

ApiResponse Api::get_frozen_picture(const Call& call) const {
  const auto frozen = frozen_in(call.path_parts.at(0));
  return {200, "image/png", text_of(encode_png(frozen->picture)), {{"Cache-Control", "no-store"}}};
}

ApiResponse Api::get_snapshot(const Call& call) const {
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  const int number = view_number(call.path_parts.at(1));
  const InspectionFolder folder = parts_.inspector.folder(inspection.id);
  for (const Snapshot& snapshot : inspection.snapshots) {
    if (snapshot.number == number) return file_answer(folder, folder.path() / snapshot.picture, "image/png");
  }
  throw not_there();
}

ApiResponse Api::get_baseline_picture(const Call& call) const {
  const std::string& name = call.path_parts.at(2);
  const int view = view_number(call.path_parts.at(1));
  const Inspection inspection = parts_.inspector.inspection(inspection_id(call));
  if (!inspection.initial || view >= static_cast<int>(inspection.views.size())) throw not_there();
  if (name == result_file::level_picture || name == result_file::depth_overlay) {
    const InspectionFolder folder = parts_.inspector.folder(inspection.id);
    return file_answer(folder, folder.baseline_check() / view_name(static_cast<std::size_t>(view)) / name,
                       "image/png");
  }
  const auto capture =
      open_capture(parts_.inspector.folder(inspection.id).capture(Side::initial, inspection, view, 0));
  if (name != "depth.png" && name != "color.png") throw not_there();
  const ColorImage picture = name == "depth.png" ? draw_depth(*capture) : draw_color(*capture);
  if (picture.empty()) throw not_there();
  return {200, "image/png", text_of(encode_png(picture)), {{"Cache-Control", "no-store"}}};
}

ApiResponse Api::get_baseline_check(const Call& call) const {
  const InspectionFolder folder = parts_.inspector.folder(inspection_id(call));
  return file_answer(folder, folder.baseline_check() / "check.json", "application/json");
}

ApiResponse Api::get_findable(const Call& /*call*/) const {
  const std::shared_ptr<const NoiseSoFar> noise = parts_.inspector.task().noise;
  if (!noise) throw not_there();
  return {200,
          "image/png",
          text_of(encode_png(draw_level_of_detection(noise->least_mm))),
          {{"Cache-Control", "no-store"}}};
}

// The comparison that the path names by its number, or else the valid one.
RecordedComparison Api::comparison_of(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  const std::optional<RecordedComparison> comparison =
      call.path_parts.size() == 1 ? parts_.inspector.inspection(id).comparison
                                  : parts_.inspector.comparison(id, view_number(call.path_parts.at(1)));
  if (!comparison) throw no_map();
  return *comparison;
}

ApiResponse Api::get_map(const Call& call) const {
  const InspectionFolder folder = parts_.inspector.folder(inspection_id(call));
  return file_answer(folder, folder.map(comparison_of(call)), "application/octet-stream", no_map());
}

ApiResponse Api::get_changes(const Call& call) const {
  const InspectionFolder folder = parts_.inspector.folder(inspection_id(call));
  return file_answer(folder, folder.changes(comparison_of(call)), "application/octet-stream", no_map());
}

ApiResponse Api::simulate_work(const Call& call) const {
  if (!parts_.simulated_work) throw Error("simulation", "the bay is not simulated", "do the work in the bay");
  parts_.simulated_work(flag_field(call.body, "done"));
  return {200, "application/json", "{}"};
}

}  // namespace rva
