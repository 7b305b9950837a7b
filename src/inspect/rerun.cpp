#include "inspect/rerun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::set<fs::path> files_in(const fs::path& folder) {
  std::error_code failure;
  std::set<fs::path> files;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (!entry->is_directory()) files.insert(entry->path().lexically_relative(folder));
  if (failure)
    throw Error(printable(folder), "cannot be read (" + failure.message() + ")",
                "check that it exists and may be read");
  return files;
}

// Without what differs between any two runs of the program.
nlohmann::json lasting_values(const std::string& text, const std::string& source) {
  nlohmann::json json = parse_json(text, source);
  if (!json.is_object()) return json;
  json.erase("runtime_ms");
  if (const auto provenance = json.find("provenance"); provenance != json.end() && provenance->is_object())
    provenance->erase("created_at");
  return json;
}

std::string line_of(const nlohmann::json& step, const nlohmann::json& recorded) {
  const auto path = step.at("path").get<std::string>();
  const nlohmann::json::json_pointer at(path);
  const auto kind = step.at("op").get<std::string>();
  if (kind == "remove") return fmt::format("{} is gone, was {}", path, json_text(recorded.at(at)));
  const std::string now = json_text(step.at("value"));
  if (kind == "add") return fmt::format("{} is {}, was not there", path, now);
  return fmt::format("{} is {}, was {}", path, now, json_text(recorded.at(at)));
}

// Empty where nothing differs that lasts.
std::vector<std::string> differing_values(const std::string& recorded_text, const std::string& text,
                                          const fs::path& name) {
  constexpr std::size_t most_lines = 5;
  const nlohmann::json recorded = lasting_values(recorded_text, printable(name));
  const nlohmann::json steps = nlohmann::json::diff(recorded, lasting_values(text, printable(name)));
  std::vector<std::string> lines;
  for (const nlohmann::json& step : steps) {
    if (lines.size() == most_lines) {
      lines.push_back(fmt::format("{}: {} more values differ", printable(name), steps.size() - most_lines));
      break;
    }
    lines.push_back(fmt::format("{}: {}", printable(name), line_of(step, recorded)));
  }
  return lines;
}

std::vector<std::string> differences_of(const fs::path& name, const fs::path& recorded,
                                        const fs::path& again) {
  if (read_file(recorded / name) == read_file(again / name)) return {};
  if (name.extension() == ".json")
    return differing_values(read_text_file(recorded / name), read_text_file(again / name), name);
  return {fmt::format("{}: has other contents", printable(name))};
}

bool is_same(const ReviewedFinding& a, const ReviewedFinding& b) {
  return a.view == b.view && a.same_as == b.same_as && a.planned == b.planned &&
         a.finding.kind == b.finding.kind && a.finding.box == b.finding.box &&
         a.finding.score == b.finding.score;
}

const ComparedRound& comparison_of(const InspectionHistory& history, int number) {
  const auto found = std::ranges::find(history.rounds, number,
                                       [](const ComparedRound& round) { return round.comparison.number; });
  if (found == history.rounds.end())
    throw Error(fmt::format("inspection {}", history.inspection.id),
                fmt::format("has no comparison {}", number), "see its rounds in the console or its report");
  return *found;
}

}  // namespace

std::vector<std::string> differences_between(const fs::path& recorded, const fs::path& again) {
  const std::set<fs::path> before = files_in(recorded);
  const std::set<fs::path> after = files_in(again);
  std::vector<std::string> lines;
  for (const fs::path& name : before) {
    if (after.contains(name))
      std::ranges::move(differences_of(name, recorded, again), std::back_inserter(lines));
    else
      lines.push_back(fmt::format("{}: was not written again", printable(name)));
  }
  for (const fs::path& name : after)
    if (!before.contains(name)) lines.push_back(fmt::format("{}: is not recorded", printable(name)));
  return lines;
}

std::vector<std::string> differences_between(const std::vector<ReviewedFinding>& recorded,
                                             const std::vector<ReviewedFinding>& again) {
  std::vector<std::string> lines;
  if (recorded.size() != again.size())
    lines.push_back(
        fmt::format("records: have {} findings, {} were found again", recorded.size(), again.size()));
  for (std::size_t i = 0; i < std::min(recorded.size(), again.size()); ++i)
    if (!is_same(recorded[i], again[i]))
      lines.push_back(fmt::format("records: finding {} was found differently", recorded[i].number));
  return lines;
}

int latest_comparison(const InspectionHistory& history) {
  if (history.rounds.empty())
    throw Error(fmt::format("inspection {}", history.inspection.id), "has no comparison",
                "give one that was captured before and after the work");
  return history.rounds.front().comparison.number;
}

Rerun rerun_comparison(const InspectionHistory& history, const InspectionFolder& folder, int number,
                       const PanTiltChain& chain, const fs::path& out, const Progress& progress) {
  const ComparedRound& recorded = comparison_of(history, number);
  const fs::path results = folder.in_comparison(recorded.comparison, "");
  if (!recorded.final || results.empty())
    throw Error(fmt::format("comparison {} of inspection {}", number, history.inspection.id),
                "is of a version that did not keep what it compared", "give a later comparison");
  Inspection as_compared = history.inspection;
  as_compared.final = recorded.final;
  const std::optional<Pose> pose =
      open_capture(folder.capture(Side::initial, as_compared, 0, 0))->info().pose;
  const bool moved = pose && pose->base;
  const Compared again = compare_sides(folder, as_compared, out, moved, chain, progress);
  Rerun rerun{files_in(results).size(), recorded.findings.size(), differences_between(results, out)};
  std::ranges::move(differences_between(recorded.findings, again.findings),
                    std::back_inserter(rerun.differences));
  return rerun;
}

}  // namespace rva
