#include "server/inspection_export.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "inspect/baseline_check.hpp"
#include "inspect/inspection_folder.hpp"
#include "inspect/view_comparison.hpp"
#include "map/view_capture.hpp"
#include "report/inspection_report.hpp"
#include "report/pdf/pdf_report.hpp"
#include "server/json_of.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* records_file = "inspection.json";
constexpr const char* report_file = "report.html";
constexpr const char* pdf_file = "report.pdf";
constexpr const char* restore = "restore the data folder from a backup";

}  // namespace

std::vector<std::string> exported_files() {
  std::vector<std::string> files{records_file,
                                 report_file,
                                 pdf_file,
                                 "regions/[0-9][0-9][0-9].json",
                                 InspectionFolder::marks_name + std::string("/*.png"),
                                 InspectionFolder::snapshots_name + std::string("/*.png")};
  const auto add = [&](const std::string& folder, const std::vector<std::string>& inside) {
    for (const std::string& file : inside) files.push_back(folder + file);
  };
  for (const char* const side : {"initial/", "initial-*/", "final/", "final-*/"})
    add(side + std::string("[0-9][0-9][0-9]/"), capture_files());
  add(InspectionFolder::baseline_check_name + std::string("/"), baseline_check_files());
  add("comparison-*/", comparison_files());
  add("", comparison_files());  // an inspection of an earlier version has them beside its captures
  return files;
}

namespace {

/// What an inspection's folder contains, by path relative to it.
class Contents {
 public:
  Contents(const InspectionHistory& history, const fs::path& data)
      : inspection_(history.inspection), folder_(data, history.inspection.id) {
    for (const CapturedRound& round : history.captured)
      for (const std::vector<fs::path>& view : captures_of(round))
        for (const fs::path& capture : view) add_folder(capture);
    for (const ComparedRound& round : history.rounds) add_comparison(round.comparison);
    if (fs::is_directory(folder_.baseline_check())) add_folder(InspectionFolder::baseline_check_name);
    for (const MarkedFinding& marked : inspection_.marked) add_file(marked.picture);
    for (const Snapshot& snapshot : inspection_.snapshots) add_file(snapshot.picture);
  }

  [[nodiscard]] const std::set<fs::path>& files() const { return files_; }
  [[nodiscard]] const fs::path& folder() const { return folder_.path(); }

  /// The folders of a round's captures, by view.
  [[nodiscard]] std::vector<std::vector<fs::path>> captures_of(const CapturedRound& round) const {
    const fs::path side = folder_.side(round.side, round.taken.round).lexically_relative(folder_.path());
    std::vector<std::vector<fs::path>> views(inspection_.views.size());
    std::size_t number = 0;
    for (std::vector<fs::path>& view : views)
      for (int k = 0; k < inspection_.dither; ++k) view.push_back(side / view_name(number++));
    return views;
  }

  /// The folders of a comparison's results, by view.
  [[nodiscard]] static std::vector<fs::path> results_of(const ComparedRound& round) {
    std::vector<fs::path> folders;
    for (const ComparedView& view : round.compared)
      folders.push_back(InspectionFolder::result_in(round.comparison.folder, view.view));
    return folders;
  }

 private:
  void add_comparison(const RecordedComparison& comparison) {
    if (!comparison.folder.empty()) return add_folder(comparison.folder);
    add_folder("results");
    for (const char* const cloud : {"map.ply", "changes.ply"})
      if (fs::exists(folder_.path() / cloud)) add_file(cloud);
  }

  void add_file(const fs::path& name) {
    folder_.require_no_links(folder_.path() / name);
    if (!fs::is_regular_file(folder_.path() / name)) throw missing(name);
    files_.insert(name);
  }

  void add_folder(const fs::path& name) {
    std::error_code failure;
    fs::recursive_directory_iterator inside(folder_.path() / name, failure);
    if (failure) throw missing(name);
    for (const fs::directory_entry& entry : inside)
      if (!entry.is_directory()) add_file(entry.path().lexically_relative(folder_.path()));
  }

  [[nodiscard]] Error missing(const fs::path& name) const {
    return {printable(folder_.path() / name), "is in the records but cannot be read", restore};
  }

  const Inspection& inspection_;
  InspectionFolder folder_;
  std::set<fs::path> files_;
};

// The C++ library reports a full disk as an error of input and output.
std::string reason_of(const std::error_code& failure, const fs::path& source, const fs::path& target) {
  std::error_code unknown;
  const fs::space_info space = fs::space(target.parent_path(), unknown);
  const bool is_full = !unknown && space.available < fs::file_size(source, unknown) && !unknown;
  return is_full ? std::make_error_code(std::errc::no_space_on_device).message() : failure.message();
}

void copy(const Contents& contents, const fs::path& out, const Progress& progress) {
  std::size_t done = 0;
  for (const fs::path& file : contents.files()) {
    throw_if_interrupted();
    std::error_code failure;
    fs::create_directories((out / file).parent_path(), failure);
    fs::copy_file(contents.folder() / file, out / file, failure);
    if (failure)
      throw Error(printable(contents.folder() / file),
                  "cannot be copied to " + printable(out / file) + ": " +
                      reason_of(failure, contents.folder() / file, out / file),
                  "check the disk and the permissions of both folders");
    if (progress) progress("copying files", ++done, contents.files().size());
  }
}

// The file of a view's regions, which `rva detect --ignore` reads.
fs::path regions_file(int view) {
  return fs::path("regions") / (view_name(static_cast<std::size_t>(view)) + ".json");
}

void write_regions(const Inspection& inspection, const fs::path& out) {
  for (const auto& [view, polygons] : inspection.ignored) {
    if (polygons.empty()) continue;
    std::error_code ignored;  // write_file() reports the error
    fs::create_directories(out / "regions", ignored);
    write_file(out / regions_file(view), json_file_text(json_of(IgnoredRegions{polygons, {}})));
  }
}

Json list_of(const std::vector<fs::path>& paths) {
  Json list = Json::array();
  for (const fs::path& path : paths) list.push_back(path.generic_string());
  return list;
}

Json record_of(const Inspection& inspection) {
  Json json = json_of(inspection);
  for (const auto& [view, polygons] : inspection.ignored)
    if (!polygons.empty()) json["views"].at(static_cast<std::size_t>(view))["regions"] = regions_file(view);
  for (std::size_t k = 0; k < inspection.marked.size(); ++k)
    json["marked"].at(k)["picture"] = inspection.marked[k].picture;
  return json;
}

Json captured_of(const InspectionHistory& history, const Contents& contents) {
  Json list = Json::array();
  for (const CapturedRound& round : history.captured) {
    Json json{{"side", name_of(round.side)}};
    json.update(json_of(round.taken));
    json["captures"] = Json::array();
    for (const std::vector<fs::path>& view : contents.captures_of(round))
      json["captures"].push_back(list_of(view));
    list.push_back(std::move(json));
  }
  return list;
}

Json rounds_of(const InspectionHistory& history) {
  Json list = Json::array();
  for (const ComparedRound& round : history.rounds) {
    list.push_back(json_of(round));
    list.back()["results"] = list_of(Contents::results_of(round));
  }
  return list;
}

Json decisions_of(const InspectionHistory& history) {
  Json list = Json::array();
  for (const RecordedDecision& decision : history.decisions) {
    Json json = decision.comparison > 0
                    ? Json{{"comparison", decision.comparison}, {"finding", decision.finding}}
                    : Json{{"marked", decision.finding}};
    json.update(json_of(decision.decision));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

void write_exported_inspection(const InspectionHistory& history, const fs::path& data, const fs::path& folder,
                               const Progress& progress) {
  const Contents contents(history, data);
  copy(contents, folder, progress);
  write_regions(history.inspection, folder);
  const std::string made_at = time_of_making();
  const ReportDocument report = report_on(history, InspectionFolder(data, history.inspection.id));
  write_file(folder / report_file, html_report(report, made_at));
  write_file(folder / pdf_file, pdf_report(report, Paper::a4));
  const Json json{{"format", "rva-inspection"},
                  {"version", 1},
                  {"inspection", record_of(history.inspection)},
                  {"captured", captured_of(history, contents)},
                  {"rounds", rounds_of(history)},
                  {"decisions", decisions_of(history)},
                  {"provenance", provenance_json(made_at)}};
  write_file(folder / records_file, json_file_text(json));
}

void export_inspection(const InspectionHistory& history, const fs::path& data, const fs::path& out,
                       Existing existing, const Progress& progress) {
  OutputFolder folder(out, exported_files(), existing);
  write_exported_inspection(history, data, folder.path(""), progress);
  folder.commit();
}

}  // namespace rva
