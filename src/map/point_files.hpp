// Point clouds in file formats of other programs.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/enum_names.hpp"
#include "map/map_cloud.hpp"

namespace rva {

/// The frame of the points, which both formats state in a comment.
enum class PointFrame {
  robot_foot,    ///< x right, y forward, z up, origin in the robot's foot
  depth_camera,  ///< x right, y down, z forward, origin in the depth imager
};
/// The texts that describe the frame in the comment of a point file.
template <>
inline constexpr auto enum_names<PointFrame> = std::to_array<EnumName<PointFrame>>({
    {PointFrame::robot_foot, "the robot's foot (x right, y forward, z up)"},
    {PointFrame::depth_camera, "the depth camera (x right, y down, z forward)"},
});

/// The content of a .ply file: binary, in metres, with colour. CloudCompare, MeshLab, Open3D and PCL open it.
[[nodiscard]] std::string encode_ply(std::span<const MapPoint> points, PointFrame frame);

/// The content of a .pcd file: binary, in metres, with colour. Open3D and PCL open it.
[[nodiscard]] std::string encode_pcd(std::span<const MapPoint> points, PointFrame frame);

/// Writes a .ply file. @throws Error when it cannot be written; it may then be incomplete
void write_ply(const std::filesystem::path& path, std::span<const MapPoint> points, PointFrame frame);

/// Writes a .pcd file. @throws Error as write_ply()
void write_pcd(const std::filesystem::path& path, std::span<const MapPoint> points, PointFrame frame);

}  // namespace rva
