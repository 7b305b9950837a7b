#include "classify/finding_classes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>

#include "audit/digest.hpp"
#include "core/path_text.hpp"
#include "depth/mat_view.hpp"
#include "detect/findings/drawing.hpp"

namespace rva {
namespace {

constexpr double surroundings = 2.0;   // times the finding's longer side
constexpr int least_px = 32;           // of surroundings: fewer pixels show no shape
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

// A square about a box, moved to lie within the picture, and cut off where the picture is smaller.
cv::Rect surroundings_of(const Box& box, cv::Size picture) {
  const int side =
      std::max(least_px, static_cast<int>(std::ceil(surroundings * std::max(box.width, box.height))));
  const cv::Size size(std::min(side, picture.width), std::min(side, picture.height));
  const cv::Point from(std::clamp(box.x + (box.width - size.width) / 2, 0, picture.width - size.width),
                       std::clamp(box.y + (box.height - size.height) / 2, 0, picture.height - size.height));
  return {from, size};
}

ColorImage part_of(const ColorImage& picture, const cv::Rect& part) {
  ColorImage copy(part.width, part.height);
  as_mat(picture)(part).copyTo(as_mat(copy));
  return copy;
}

// @param box of the finding in the picture
FindingClass class_of(const Finding& finding, const Box& box, const ColorImage& picture, ObjectModel& model) {
  const cv::Rect part = surroundings_of(box, {picture.width(), picture.height()});
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
