#include "classify/finding_classes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "audit/digest.hpp"
#include "classify/finding_planes.hpp"
#include "classify/surroundings.hpp"
#include "core/path_text.hpp"
#include "detect/findings/drawing.hpp"

namespace rva {
namespace {

constexpr double least_overlap = 0.2;  // with the finding's box

// @param box of the finding in the picture
FindingClass class_of(const Finding& finding, const Box& box, const ColorImage& picture, ObjectModel& model) {
  const Box part = surroundings_of(box, picture.width(), picture.height());
  const cv::Rect2d there(box.x - part.x, box.y - part.y, box.width, box.height);
  FindingClass found{finding.id, std::string(unknown_class), std::nullopt};
  for (const ModelObject& object : model.objects_in(part_of(picture, part))) {
    if (overlap(object.box, there) < least_overlap) continue;
    found.probability = object.probability;
    if (object.probability >= model.options().class_certainty) found.name = model.label(object.label);
    break;  // the first is the most probable
  }
  return found;
}

// The box of a finding in the picture; empty if it lies outside.
std::optional<Box> box_in(const FindingPicture& picture, const Finding& finding, const Detection& detection,
                          const CaptureInfo& final) {
  if (!picture.is_color) return finding.box;
  return box_on_color(finding, detection.final_m, final, picture.image);
}

}  // namespace

FindingClasses classify(const ShownFindings& shown, FindingModel& model) {
  FindingClasses classes{shown.picture, {}};
  for (const ShownFinding& finding : shown.findings) {
    const LikelyClass likely = model.classify(finding.planes);
    classes.findings.push_back({finding.finding,
                                likely.unknown ? std::string(unknown_class) : model.labels()[likely.number],
                                likely.probability});
  }
  return classes;
}

std::optional<FindingClasses> classify(const Detection& detection, const Capture& final, ObjectModel& model) {
  const std::optional<FindingPicture> picture = picture_of(final);
  if (!picture) return std::nullopt;
  FindingClasses classes{picture->is_color ? "color" : "infrared", {}};
  for (const Finding& finding : detection.findings.findings) {
    const auto box = box_in(*picture, finding, detection, final.info());
    if (box) classes.findings.push_back(class_of(finding, *box, picture->image, model));
  }
  return classes;
}

nlohmann::ordered_json described(const ObjectModel& model) {
  nlohmann::ordered_json stated{{"model", printable(model.file().filename())},
                                {"sha256", hex_of(bytes_of(sha256_of_file(model.file())))},
                                {"classes", model.classes()}};
  ModelOptions::describe(model.options(), [&](const auto& value, const OptionField& field) {
    stated[json_name(field)] = value;
  });
  return stated;
}

nlohmann::ordered_json described(const FindingModel& model) {
  return {{"model", model.name()},
          {"sha256", model.sha256()},
          {"classes", model.labels().size()},
          {"class_certainty", model.least_probability()}};
}

void add_classes(const FindingClasses& classes, nlohmann::ordered_json model,
                 nlohmann::ordered_json& detections) {
  for (nlohmann::ordered_json& finding : detections["detections"]) {
    const auto found = std::ranges::find(classes.findings, finding["id"].get<int>(), &FindingClass::finding);
    if (found == classes.findings.end()) continue;
    finding["class"] = found->name;
    if (found->probability) finding["probability"] = *found->probability;
  }
  model["picture"] = classes.picture;
  detections["classification"] = std::move(model);
}

}  // namespace rva
