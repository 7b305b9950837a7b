// Findings that people mark: where they are in the bay, and the pictures that show them.
#pragma once

#include <string>

#include "capture/capture.hpp"
#include "depth/image.hpp"
#include "geometry/pan_tilt.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

/// @throws Error when a box is empty, or not wholly inside a picture of this size
void require_inside(const Box& box, int width, int height);

/// Finds the surface that a box of a view's depth image shows: the median depth of the middle half of the
/// box, if at least a third of it is measured.
/// @param capture of whose depth image the box is
/// @return a mark with its box, and with position and size where they were measured
/// @throws Error when the box is not inside the depth image, or the capture cannot be read
[[nodiscard]] MarkedFinding located_mark(const Capture& capture, const Box& box, const PanTiltChain& chain);

/// The picture of a view after the work, of the current comparison, which there must be: the one in colour,
/// otherwise the one of depth.
/// @return its path relative to the inspection's folder
[[nodiscard]] std::string review_picture(const InspectionFolder& folder, const Inspection& inspection,
                                         int view);

/// Writes a picture that a person keeps, under a name that no other one has.
/// @param kind the folder: InspectionFolder::marks_name or snapshots_name
/// @return its path relative to the inspection's folder
/// @throws Error when it cannot be written
[[nodiscard]] std::string keep_picture(const InspectionFolder& folder, const std::string& kind,
                                       const ColorImage& picture);

}  // namespace rva
