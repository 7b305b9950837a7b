#include "inspect/labelled_crops.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <vector>

#include "classify/finding_planes.hpp"
#include "classify/surroundings.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"
#include "inspect/inspection_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array pictures{"initial_color", "final_color", "initial_depth", "final_depth"};

// The pictures of a view, of which each is read once for all findings in it.
class ViewPictures {
 public:
  explicit ViewPictures(fs::path result) : result_(std::move(result)) {}

  // Null where there is none, as there is no colour in darkness.
  const ColorImage* find(const std::string& name) {
    const auto [known, is_new] = read_.try_emplace(name);
    const fs::path file = result_ / (name + ".png");
    std::error_code ignored;
    if (is_new && (name == "final_depth" || fs::exists(file, ignored))) known->second = read_color(file);
    return known->second.empty() ? nullptr : &known->second;
  }

 private:
  fs::path result_;
  std::map<std::string, ColorImage> read_;
};

// Cuts a finding out of a picture, and states its file and where it is in there.
void write_crop(const ColorImage& picture, const Box& box, const std::string& name, const std::string& file,
                const fs::path& folder, Json& crop) {
  const Box part = surroundings_of(box, picture.width(), picture.height());
  write_file(folder / file, encode_png(part_of(picture, part)));
  crop["files"][name] = file;
  crop["box_in_crop"] = {box.x - part.x, box.y - part.y, box.width, box.height};
}

Json described(const Inspection& inspection, std::string_view label, const Decision& decision, int number) {
  Json crop;
  crop["label"] = label;
  crop["verdict"] = name_of(decision.verdict);
  crop["note"] = decision.note;
  if (!decision.object.empty()) crop["object"] = decision.object;
  crop["inspection"] = inspection.id;
  crop["finding"] = number;
  return crop;
}

Json of_finding(const Inspection& inspection, const ReviewedFinding& reviewed, std::string_view label,
                int comparison, ViewPictures& view, const fs::path& folder) {
  const Finding& finding = reviewed.finding;
  Json crop = described(inspection, label, *reviewed.decision, reviewed.number);
  crop["comparison"] = comparison;
  crop["view"] = reviewed.view;
  crop["kind"] = name_of(finding.kind);
  if (finding.size_mm) crop["size_mm"] = *finding.size_mm;
  if (finding.height_mm) crop["height_mm"] = *finding.height_mm;
  for (const char* const name : pictures)
    if (const ColorImage* const picture = view.find(name))
      write_crop(
          *picture, finding.box, name,
          fmt::format("{}/{:06}-{}-{:03}-{}.png", label, inspection.id, comparison, reviewed.number, name),
          folder, crop);
  return crop;
}

void add_findings(const Inspection& inspection, const ComparedRound& round, const fs::path& comparison,
                  const fs::path& folder, Json& crops) {
  std::map<int, ViewPictures> views;
  for (const ReviewedFinding& finding : round.findings) {
    const auto label = label_of(finding.decision);
    if (!label || finding.planned == PlannedState::missing) continue;
    ViewPictures& view =
        views.try_emplace(finding.view, InspectionFolder::result_in(comparison, finding.view)).first->second;
    crops.push_back(of_finding(inspection, finding, *label, round.comparison.number, view, folder));
  }
}

// What a finding is, for training; empty where nobody stated it.
std::optional<std::string> kind_of(const Decision& decision) {
  if (decision.verdict == Verdict::false_alarm) return "";
  return decision.object.empty() ? std::nullopt : std::optional(decision.object);
}

// Adds the findings whose kind is known, if the comparison kept what the classifier was shown.
void add_shown(const Inspection& inspection, const ComparedRound& round, const fs::path& comparison,
               LabelledCrops& all) {
  const fs::path file = comparison / InspectionFolder::shown_findings;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const std::vector<std::byte> bytes = read_file(file);
  const auto halves = halves_in(bytes, printable(file));
  std::size_t next = 0;
  for (const ReviewedFinding& finding : round.findings) {
    if (finding.likely_class.empty()) continue;
    if (next == halves.size())
      throw Error(printable(file), "lacks findings that are recorded", "compare the inspection again");
    const std::span<const std::byte> planes = halves[next++];
    const auto kind = label_of(finding.decision) ? kind_of(*finding.decision) : std::nullopt;
    if (!kind) continue;
    all.planes.append(reinterpret_cast<const char*>(planes.data()), planes.size());
    all.shown.push_back({{"kind", *kind},
                         {"inspection", inspection.id},
                         {"comparison", round.comparison.number},
                         {"finding", finding.number}});
  }
}

void add_marks(const Inspection& inspection, const fs::path& own, const fs::path& folder, Json& crops) {
  for (const MarkedFinding& mark : inspection.marked) {
    const auto label = label_of(mark.decision);
    if (!label) continue;
    Json crop = described(inspection, *label, *mark.decision, mark.number);
    crop["marked"] = true;
    if (mark.size_mm) crop["size_mm"] = *mark.size_mm;
    write_crop(read_color(own / mark.picture), mark.box, "picture",
               fmt::format("{}/{:06}-marked-{:03}-picture.png", *label, inspection.id, mark.number), folder,
               crop);
    crops.push_back(crop);
  }
}

constexpr std::array labels{"debris", "installed-work", "false-alarm"};

}  // namespace

std::optional<std::string_view> label_of(const std::optional<Decision>& decision) {
  if (!decision) return std::nullopt;
  switch (decision->verdict) {
    case Verdict::debris:
    case Verdict::debris_removed:
    case Verdict::debris_unreachable:
      return labels[0];
    case Verdict::installed_work:
      return labels[1];
    case Verdict::false_alarm:
      return labels[2];
    case Verdict::second_look:
    case Verdict::undecided:
      break;
  }
  return std::nullopt;
}

std::vector<std::string> labelled_crop_files() {
  std::vector<std::string> files{"crops.json", "findings.json", "planes.f16"};
  for (const char* const label : labels) files.push_back(fmt::format("{}/*.png", label));
  return files;
}

LabelledCrops write_labelled_crops(const InspectionHistory& history, const fs::path& data,
                                   const fs::path& folder) {
  const Inspection& inspection = history.inspection;
  const InspectionFolder own(data, inspection.id);
  for (const char* const label : labels) fs::create_directories(folder / label);
  LabelledCrops all;
  for (const ComparedRound& round : history.rounds) {
    const fs::path comparison = own.in_comparison(round.comparison, "");
    if (comparison.empty()) continue;
    add_findings(inspection, round, comparison, folder, all.crops);
    add_shown(inspection, round, comparison, all);
  }
  add_marks(inspection, own.path(), folder, all.crops);
  return all;
}

}  // namespace rva
