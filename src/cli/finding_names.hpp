// What findings may be, by the model that the user chose.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "classify/finding_classes.hpp"
#include "plan/plan_match.hpp"

namespace rva::cli {

/// The flags --classify, --classifier, --model, and those of a model.
struct NamingFlags {
  bool classify = false;   ///< whether the classifier that comes with the program is used
  std::string classifier;  ///< card of another one; empty: none
  std::string model;       ///< file of an object detector; empty: none
  std::string labels;      ///< file of its labels
  ModelOptions options;    ///< of the object detector

  /// Adds them to a command, of which they are members: they must outlive it.
  void add_to(CLI::App& command);
};

/// The model that was chosen, if any.
class NamingModel {
 public:
  /// @throws Error, UsageError when the model cannot be read or does not fit
  explicit NamingModel(const NamingFlags& flags);

  /// Adds the classes to the content of detections.json.
  /// @param warnings gets one if there is no picture that an object detector could be shown
  /// @return empty where there is no model, or nothing to show it
  std::optional<FindingClasses> name_findings(const Detection& detection, const Capture& final,
                                              nlohmann::ordered_json& json,
                                              std::vector<std::string>& warnings);

 private:
  std::optional<ObjectModel> objects_;
  std::optional<FindingModel> findings_;
};

/// Prints what findings may be. Planned findings are printed as groups elsewhere, and left out here.
void print_classes(const FindingClasses& classes, const std::optional<PlanMatch>& match);

}  // namespace rva::cli
