// A map as files that others open.
#pragma once

#include <filesystem>
#include <span>

#include "map/map_cloud.hpp"

namespace rva {

// Binary, metres, with colour: what CloudCompare, MeshLab, Open3D (both) and PCL (both) open.
// @throws Error when it cannot be written; it may then be incomplete
void write_ply(const std::filesystem::path& path, std::span<const MapPoint> points);
void write_pcd(const std::filesystem::path& path, std::span<const MapPoint> points);

}  // namespace rva
