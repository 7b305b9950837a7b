#include "classify/finding_classes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>

#include "audit/digest.hpp"
#include "classify/surroundings.hpp"
#include "core/path_text.hpp"
#include "detect/findings/drawing.hpp"

namespace rva {
namespace {

constexpr double least_overlap = 0.2;  // with the finding's box

ColorImage colored(const Image<float>& grey_levels) {
  ColorImage picture(grey_levels.width(), grey_levels.height());
  constexpr float white = 255.0F;
  for (std::size_t i = 0; i < grey_levels.size(); ++i) {
    const auto level = static_cast<std::uint8_t>(std::lround(std::clamp(grey_levels[i], 0.0F, white)));
    picture[i] = {level, level, level};
  }
  return picture;
}

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

}  // namespace

std::optional<FindingClasses> classify(const Detection& detection, const Capture& final, ObjectModel& model) {
  const bool has_color = final.color_frames() > 0;
  std::optional<ColorImage> picture;
  if (has_color) {
    picture = final.color(0);
  } else if (const auto infrared = final.infrared_mean(Imager::left, Light::projector)) {
    picture = colored(*infrared);
  }
  if (!picture) return std::nullopt;
  FindingClasses classes{has_color ? "color" : "infrared", {}};
  for (const Finding& finding : detection.findings.findings) {
    const auto box =
        has_color ? box_on_color(finding, detection.final_m, final.info(), *picture) : finding.box;
    if (box) classes.findings.push_back(class_of(finding, *box, *picture, model));
  }
  return classes;
}

void add_classes(const FindingClasses& classes, const ObjectModel& model,
                 nlohmann::ordered_json& detections) {
  for (nlohmann::ordered_json& finding : detections["detections"]) {
    const auto found = std::ranges::find(classes.findings, finding["id"].get<int>(), &FindingClass::finding);
    if (found == classes.findings.end()) continue;
    finding["class"] = found->name;
    if (found->probability) finding["probability"] = *found->probability;
  }
  const ModelOptions& options = model.options();
  nlohmann::ordered_json& stated = detections["classification"];
  stated["model"] = printable(model.file().filename());
  stated["sha256"] = hex_of(bytes_of(sha256_of_file(model.file())));
  stated["classes"] = model.classes();
  stated["picture"] = classes.picture;
  ModelOptions::describe(
      options, [&](const auto& value, const OptionField& field) { stated[json_name(field)] = value; });
}

}  // namespace rva
