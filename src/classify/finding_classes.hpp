// What findings may be, by a model that reports objects in pictures (thesis 4.2.1).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/capture.hpp"
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
                                      ///< empty where objects_in() has none there
};

/// The classes of findings.
struct FindingClasses {
  std::string_view picture;            ///< "color" or "infrared": what the model was shown
  std::vector<FindingClass> findings;  ///< without those that lie outside the colour image
};

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

/// Adds class and probability to each finding in the content of `detections.json`, and the model to the
/// whole.
void add_classes(const FindingClasses& classes, const ObjectModel& model, nlohmann::ordered_json& detections);

}  // namespace rva
