// Reads the views by which a robot is calibrated.
#pragma once

#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "map/map_view.hpp"

namespace rva {

/// Reads captures that one camera took on one robot whose foot did not move, as map_bay() writes them. The
/// views are named by their paths.
/// @throws Error when a capture is given twice, is of another base or another camera than the first, or does
///         not state its base; as load_map_view()
[[nodiscard]] std::vector<MapView> load_calibration_views(const std::vector<std::filesystem::path>& captures,
                                                          const Progress& progress);

}  // namespace rva
