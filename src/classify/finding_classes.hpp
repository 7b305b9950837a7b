// What findings may be, by the classifier that comes with RVA or by an object detector (thesis 4.2.1).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/capture.hpp"
#include "classify/finding_model.hpp"
#include "classify/finding_planes.hpp"
#include "classify/object_model.hpp"
#include "detect/findings/detection.hpp"

namespace rva {

/// The class of findings that a model has no certain class for.
inline constexpr std::string_view unknown_class = "unknown";

/// What a finding may be. A class never removes a finding, nor changes the order of findings.
struct FindingClass {
  int finding = 0;                    ///< id
  std::string name;                   ///< a label of the model, or unknown_class
  std::optional<double> probability;  ///< of the label that is the most probable, also of an unknown class;
                                      ///< empty where an object detector reports none there
};

/// The classes of findings.
struct FindingClasses {
  std::string_view picture;            ///< "color", "infrared" or, with depth alone, "none"
  std::vector<FindingClass> findings;  ///< of those that the model was shown, in their order
};

/// What a classifier calls findings that it is shown: their surroundings in pictures and depth, their sizes
/// and heights (finding_planes.hpp). Findings that were removed, have no position, or lie outside the colour
/// image are not shown, and get no class.
/// @throws Error as FindingModel::classify()
[[nodiscard]] FindingClasses classify(const ShownFindings& shown, FindingModel& model);

/// Shows a model the surroundings of each finding in the final capture, from the first colour image or, where
/// there is none, from the left imager's infrared images. The surroundings are a square about the finding,
/// twice as wide as it and within the picture. The class is that of the most probable object whose box
/// overlaps the finding's by at least 20 % (intersection over union); it is unknown if there is none or if it
/// is less probable than the option class_certainty.
/// @param final the first final capture, in whose view the findings are
/// @return empty where the capture has no such images
/// @throws Error when an image is damaged, or as ObjectModel::objects_in()
[[nodiscard]] std::optional<FindingClasses> classify(const Detection& detection, const Capture& final,
                                                     ObjectModel& model);

/// The content of `classification` in `detections.json`: the model's file name, SHA-256, number of classes,
/// and from when its classes count.
[[nodiscard]] nlohmann::ordered_json described(const ObjectModel& model);
/// @overload
[[nodiscard]] nlohmann::ordered_json described(const FindingModel& model);

/// Adds class and probability to each finding in the content of `detections.json`, and the model to the
/// whole.
/// @param model as described() returns it
void add_classes(const FindingClasses& classes, nlohmann::ordered_json model,
                 nlohmann::ordered_json& detections);

}  // namespace rva
