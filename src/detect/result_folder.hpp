// The folder of a detection's result: the names of its files, and their one writer.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/capture.hpp"
#include "detect/detect.hpp"
#include "detect/provenance.hpp"

namespace rva {

/// Names of the files of a result. docs/detection.md describes what they contain.
namespace result_file {
inline constexpr std::string_view detections = "detections.json";
inline constexpr std::string_view changes = "changes.png";                ///< mask of all changed pixels
inline constexpr std::string_view depth_overlay = "depth_overlay.png";    ///< findings on the depth image
inline constexpr std::string_view overlay = "overlay.png";                ///< findings on the colour image
inline constexpr std::string_view changed_points = "changed_points.png";  ///< of the octree method
inline constexpr std::string_view registration = "registration.json";     ///< if views were registered
inline constexpr std::string_view level = "level_of_detection.json";      ///< of methods that estimate it
inline constexpr std::string_view level_picture = "level_of_detection.png";
inline constexpr std::string_view plan = "plan.json";  ///< findings compared with a plan, if there was one
}  // namespace result_file

/// All files that a result may have, in the form that OutputFolder takes.
[[nodiscard]] std::vector<std::string> result_files();

/// The summary in `level_of_detection.json`, with the shares that are findable.
/// @param detection has a level of detection
/// @param final     the camera of the first final capture
[[nodiscard]] DetectionLevelSummary level_summary(const Detection& detection, const Intrinsics& final);

/// The content of `detections.json`, with its provenance last where that is given.
[[nodiscard]] nlohmann::ordered_json detections_json(const Findings& findings,
                                                     const std::optional<Provenance>& provenance);

/// Writes a result. Files that do not apply are left out: pictures on the colour image where there is none,
/// for example.
/// @param final  the first final capture, in whose view the findings are
/// @param folder exists
/// @param detections the content of `detections.json`: detections_json(), with anything added to it
/// @return       warnings for the user on pictures that are missing or only approximate
/// @throws Error when a file cannot be written
[[nodiscard]] std::vector<std::string> write_result(const SidesDetection& result, const Capture& final,
                                                    const std::filesystem::path& folder,
                                                    const nlohmann::ordered_json& detections);

}  // namespace rva
