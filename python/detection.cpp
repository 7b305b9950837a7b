#include "detection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "detect/result_folder.hpp"

namespace rva::python {
namespace {

std::string height_of(const Finding& finding) {
  if (finding.kind == ChangeKind::added && finding.top_above_surroundings_mm)
    return fmt::format(", {}{:.1f} mm high", finding.top_is_least ? "at least " : "",
                       *finding.top_above_surroundings_mm);
  if (finding.height_mm) return fmt::format(", depth changed by {:.1f} mm", *finding.height_mm);
  return "";
}

std::string name_in_words(const FindingClass& named) {
  const std::string name = printable(named.name);
  if (!named.probability) return fmt::format(", may be: {}", name);
  return fmt::format(", may be: {} ({:.0f} % for the most probable class)", name, 100.0 * *named.probability);
}

}  // namespace

const FindingClass* ResultFinding::named() const {
  if (!result->classes) return nullptr;
  const auto& all = result->classes->findings;
  const auto found = std::ranges::find(all, finding().id, &FindingClass::finding);
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> write(const DetectionResult& result, const OutputFolder& out) {
  if (result.plan) write_file(out.path(result_file::plan), json_file_text(*result.plan));
  return write_result(result.sides, *result.final->capture, out.path(""), result.json);
}

std::string text_of(const ResultFinding& self) {
  const Finding& finding = self.finding();
  const Box& box = finding.box;
  std::string text = fmt::format("{} {}", finding.id, name_of(finding.kind));
  if (finding.size_mm)
    text += fmt::format(", {:.1f} x {:.1f} mm", (*finding.size_mm)[0], (*finding.size_mm)[1]);
  text += height_of(finding);
  if (finding.position_m) text += fmt::format(", {:.2f} m away", finding.position_m->z());
  text += fmt::format(", at ({}, {}) of {} x {} px", box.x, box.y, box.width, box.height);
  if (finding.score) text += fmt::format(", score {:.1f}", *finding.score);
  if (finding.moved_from) text += fmt::format(", may be {}, moved", *finding.moved_from);
  if (const FindingClass* named = self.named()) text += name_in_words(*named);
  return text;
}

std::string text_of(const std::shared_ptr<const DetectionResult>& result) {
  const Findings& findings = result->sides.detection.findings;
  std::string text = fmt::format("{} finding(s), method {}, {} + {} frames", findings.findings.size(),
                                 findings.method, findings.initial_frames, findings.final_frames);
  for (std::size_t i = 0; i < findings.findings.size(); ++i)
    text += "\n  " + text_of(ResultFinding{result, i});
  const Coverage& coverage = findings.coverage;
  text += fmt::format("\ncompared {:.1f} % of the view; not seen before {:.1f} %, no measurement {:.1f} %",
                      100.0 * coverage.compared, 100.0 * coverage.unseen, 100.0 * coverage.invalid);
  for (const std::string& warning : result->warnings) text += "\nwarning: " + warning;
  return text;
}

}  // namespace rva::python
