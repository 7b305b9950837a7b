// The bay as a point cloud, for the console's 3D view.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "capture/capture.hpp"
#include "detect/findings/detection.hpp"
#include "geometry/pan_tilt.hpp"
#include "inspect/inspection_folder.hpp"
#include "map/map_cloud.hpp"

namespace rva {

/// The pose of a capture's camera: the one that the capture states, or else that of a camera on a robot with
/// both joints at 0.
[[nodiscard]] Transform map_from_camera(const CaptureInfo& info, const PanTiltChain& chain);

/// Writes the final captures of all views to `file` as one point cloud in the frame of the robot's foot. If a
/// robot carried the camera, the poses are refined where the captures overlap.
/// @param moved whether a robot carried the camera
/// @throws Error when a capture cannot be read or the map cannot be written; Interrupted
void write_inspection_map(const std::filesystem::path& file, const InspectionFolder& folder,
                          const Inspection& inspection, bool moved, const PanTiltChain& chain);

/// A point in the map's frame for each pixel of each finding whose final depth is known, in the colour of
/// that pixel in `picture`.
/// @param picture the view's changes (ReviewPictures::changed), coloured by kind, brighter the greater the
///                height
[[nodiscard]] std::vector<MapPoint> changed_points(const Detection& detection, const ColorImage& picture,
                                                   const Intrinsics& camera,
                                                   const Transform& map_from_camera);

}  // namespace rva
