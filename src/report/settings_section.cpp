#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"
#include "detect/result_folder.hpp"
#include "report/or_reason.hpp"
#include "report/report_sections.hpp"
#include "report/report_words.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::string camera_text(const CaptureInfo& info) {
  if (!info.camera) return "camera not stated";
  std::vector<std::string> parts;
  if (!info.camera->model.empty()) parts.push_back(info.camera->model);
  if (!info.camera->serial.empty()) parts.push_back("serial number " + info.camera->serial);
  if (!info.camera->firmware.empty()) parts.push_back("firmware " + info.camera->firmware);
  if (info.camera->baseline_m)
    parts.push_back(fmt::format("imagers {:.1f} mm apart", mm_per_m * *info.camera->baseline_m));
  return parts.empty() ? "camera not stated" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string exposure_text(const CaptureInfo& info) {
  if (!info.infrared) return "exposure not stated";
  std::vector<std::string> parts;
  if (info.infrared->exposure_us) parts.push_back(fmt::format("{:g} µs", *info.infrared->exposure_us));
  if (info.infrared->gain) parts.push_back(fmt::format("gain {:g}", *info.infrared->gain));
  if (info.infrared->laser_power_mw)
    parts.push_back(fmt::format("projector {:g} mW", *info.infrared->laser_power_mw));
  return parts.empty() ? "exposure not stated" : fmt::format("{}", fmt::join(parts, ", "));
}

// What the first capture of a side states; it is the same for the others.
Content capture_text(const Capture& capture, int dither) {
  const Intrinsics& depth = capture.info().depth;
  return Content::text(fmt::format(
      "{}; {} × {} pixels, {}, {} of each view; {}", camera_text(capture.info()), depth.width, depth.height,
      counted(capture.depth_frames(), "image a capture", "images a capture"),
      counted(static_cast<std::size_t>(dither), "capture", "captures"), exposure_text(capture.info())));
}

std::vector<Content> row_of(const Inspection& inspection, const InspectionFolder& folder, Side side,
                            const TakenSide& taken) {
  return {Content::text(side == Side::initial ? "Baseline" : "After the work"),
          Content::text(time_text(taken.taken_at) + ", by ") + Content::typed(taken.person), or_reason([&] {
            const fs::path capture = folder.capture(side, inspection, 0, 0);
            folder.require_no_links(capture / "capture.json");
            return capture_text(*open_capture(capture), inspection.dither);
          })};
}

std::string value_text(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : json_text(value);
}

// The method of a view with every option that affected its result, as the result states them.
Content method_of(const InspectionFolder& folder, const fs::path& result, const ComparedView& view) {
  const fs::path file = result / result_file::detections;
  folder.require_no_links(file);
  const nlohmann::json json = parse_json(read_text_file(file), printable(file));
  std::vector<std::string> options;
  if (const auto parameters = json.find("parameters"); parameters != json.end() && parameters->is_object())
    for (const auto& [name, value] : parameters->items()) options.push_back(name + " " + value_text(value));
  const Content program = Content::text(fmt::format("View {}: method {}", view.view + 1, view.method));
  return Content::of(PartRole::paragraph, program + Content::text(options.empty() ? "" : ", with ") +
                                              Content::typed(fmt::format("{}", fmt::join(options, ", "))));
}

Content methods_of(const Inspection& inspection, const InspectionFolder& folder) {
  if (!inspection.comparison || folder.in_comparison(*inspection.comparison, "").empty()) return {};
  Content methods;
  for (const ComparedView& view : inspection.compared)
    methods += or_reason([&] { return method_of(folder, folder.result(inspection, view.view), view); });
  return methods;
}

}  // namespace

Content settings_section(const InspectionHistory& history, const InspectionFolder& folder) {
  const Inspection& inspection = history.inspection;
  ReportTable table{.role = PartRole::table,
                    .head = {Content::text("Captures"), Content::text("Taken"), Content::text("With")},
                    .rows = {}};
  if (inspection.initial)
    table.rows.push_back(row_of(inspection, folder, Side::initial, *inspection.initial));
  if (inspection.final) table.rows.push_back(row_of(inspection, folder, Side::final, *inspection.final));
  Content content = table.rows.empty() ? Content() : content_of(table);
  content += methods_of(inspection, folder);
  return content.empty() ? content
                         : Content::of(PartRole::heading, Content::text("Settings")) +
                               Content::of(PartRole::settings, content);
}

}  // namespace rva
