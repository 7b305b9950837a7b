// Findings that people decided on, as small labelled pictures: what a classifier can be trained with
// (thesis 4.2.1).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// The label of a finding: `debris`, whatever became of it, `installed-work` or `false-alarm`. Empty where
/// nobody has decided, or asked for a second look.
[[nodiscard]] std::optional<std::string_view> label_of(const std::optional<Decision>& decision);

/// The files of labelled crops, as patterns for an OutputFolder; the first is in each.
[[nodiscard]] std::vector<std::string> labelled_crop_files();

/// The labelled findings of an inspection.
struct LabelledCrops {
  /// For each finding its label, note, kind, sizes, box in the crops, and files by picture.
  nlohmann::ordered_json crops = nlohmann::ordered_json::array();
  /// What training/train.py takes: findings of which it is known what they are, each with its `kind`. That is
  /// the name that the person gave the object; empty for a false alarm.
  nlohmann::ordered_json shown = nlohmann::ordered_json::array();
  std::string planes;  ///< of those findings (finding_planes.hpp), 16-bit floats one after the other
};

/// Cuts the surroundings (surroundings_of()) of each finding with a label out of the pictures of its
/// comparison, before and after the work, in colour and depth as far as they exist, and of each marked
/// finding out of the picture in which it was marked. Parts of a plan that are missing are no findings here.
/// The names are LABEL/INSPECTION-COMPARISON-FINDING-PICTURE.png.
/// @param data   the folder of all inspections
/// @param folder exists; what is written is incomplete if this throws
/// @throws Error when a picture is missing or damaged, or a file cannot be written
[[nodiscard]] LabelledCrops write_labelled_crops(const InspectionHistory& history,
                                                 const std::filesystem::path& data,
                                                 const std::filesystem::path& folder);

}  // namespace rva
