// The bay as a cloud of points, for a person to turn.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "depth/capture.hpp"
#include "detect/detection.hpp"
#include "geometry/pan_tilt.hpp"
#include "inspect/inspection_folder.hpp"
#include "map/map_cloud.hpp"

namespace rva {

/// Where a capture's camera stood: as its pose says; where it says nothing, as if a robot looked level.
[[nodiscard]] Transform map_from_camera(const CaptureInfo& info, const PanTiltChain& chain);

/// Joins the final captures of all views into `file`. Poses of a robot's views are corrected by what the
/// views share.
/// @param moved a robot carried the camera
/// @throws Error when a capture cannot be read, or the map not be written; Interrupted
void write_inspection_map(const std::filesystem::path& file, const InspectionFolder& folder,
                          const Inspection& inspection, bool moved, const PanTiltChain& chain);

/// Every pixel of every finding as a point in the map's frame, coloured by kind, brighter the higher.
/// @param picture of the view's changes (ReviewPictures::changed)
[[nodiscard]] std::vector<MapPoint> changed_points(const Detection& detection, const ColorImage& picture,
                                                   const Intrinsics& camera,
                                                   const Transform& map_from_camera);

}  // namespace rva
