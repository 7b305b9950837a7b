#include "map/point_files.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/file.hpp"

namespace rva {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Number>
void append(const Number& number, std::string& bytes) {
  static_assert(std::is_arithmetic_v<Number>);
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());
}

void append(const Eigen::Vector3f& position_m, std::string& bytes) {
  for (const float coordinate_m : position_m) append(coordinate_m, bytes);
}

}  // namespace

// Both formats are a short header and numbers. PCL's writers are not used: they add a camera to one of the
// formats, which CloudCompare complains about, and do not detect a full disk. tests/map reads the files by
// PCL's readers.
std::string encode_ply(std::span<const MapPoint> points, PointFrame frame) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment metres, in the frame of {}\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
      name_of(frame), points.size());
  for (const MapPoint& point : points) {
    append(point.position_m, bytes);
    for (const std::uint8_t shade : {point.color.r, point.color.g, point.color.b}) append(shade, bytes);
  }
  return bytes;
}

std::string encode_pcd(std::span<const MapPoint> points, PointFrame frame) {
  std::string bytes = fmt::format(
      "# .PCD v0.7 - metres, in the frame of {1}\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\n"
      "TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH {0}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\nDATA binary\n",
      points.size(), name_of(frame));
  for (const MapPoint& point : points) {
    append(point.position_m, bytes);
    append((std::uint32_t{point.color.r} << 16U) | (std::uint32_t{point.color.g} << 8U) | point.color.b,
           bytes);
  }
  return bytes;
}

void write_ply(const std::filesystem::path& path, std::span<const MapPoint> points, PointFrame frame) {
  write_file(path, encode_ply(points, frame));
}

void write_pcd(const std::filesystem::path& path, std::span<const MapPoint> points, PointFrame frame) {
  write_file(path, encode_pcd(points, frame));
}

}  // namespace rva
