#include "classify/naming_model.hpp"

#include <nlohmann/json.hpp>

#include "classify/labels.hpp"

namespace rva {

NamingModel::NamingModel(const NamingChoice& choice) {
  if (!choice.model.empty())
    objects_.emplace(choice.model, read_labels(choice.labels), choice.options);
  else if (!choice.classifier.empty())
    findings_.emplace(FindingModel::read(choice.classifier));
  else if (choice.classify)
    findings_.emplace(FindingModel::shipped());
}

std::optional<FindingClasses> NamingModel::name_findings(const Detection& detection, const Capture& final,
                                                         nlohmann::ordered_json& json,
                                                         std::vector<std::string>& warnings) {
  if (!objects_ && !findings_) return std::nullopt;
  auto classes = objects_ ? classify(detection, final, *objects_)
                          : std::optional(classify(shown_findings(detection, final), *findings_));
  if (classes)
    add_classes(*classes, objects_ ? described(*objects_) : described(*findings_), json);
  else
    warnings.emplace_back("the final capture has neither colour nor infrared images to classify findings by");
  return classes;
}

}  // namespace rva
