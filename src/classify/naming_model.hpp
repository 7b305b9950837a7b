// Names what findings may be, by the model that the user chose.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "classify/finding_classes.hpp"
#include "classify/finding_model.hpp"
#include "classify/object_model.hpp"
#include "detect/findings/detection.hpp"

namespace rva {

/// By which model findings are named: by one of them at most.
struct NamingChoice {
  bool classify = false;   ///< whether the classifier that comes with the program is used
  std::string classifier;  ///< card of another one; empty: none
  std::string model;       ///< file of an object detector; empty: none
  std::string labels;      ///< file of its labels
  ModelOptions options;    ///< of the object detector
};

/// The model that was chosen, if any.
class NamingModel {
 public:
  /// @throws Error, UsageError when the model cannot be read or does not fit
  explicit NamingModel(const NamingChoice& choice);

  /// Adds the classes to the content of detections.json.
  /// @param warnings gets one if there is no picture that an object detector could be shown
  /// @return empty where there is no model, or nothing to show it
  [[nodiscard]] std::optional<FindingClasses> name_findings(const Detection& detection, const Capture& final,
                                                            nlohmann::ordered_json& json,
                                                            std::vector<std::string>& warnings);

 private:
  std::optional<ObjectModel> objects_;
  std::optional<FindingModel> findings_;
};

}  // namespace rva
