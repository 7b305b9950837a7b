// Depth images in PNG, TIFF, PGM, NumPy and OpenEXR files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// The depth images of a folder, in the order of image_files(). Some tools write each image in several
/// formats: only files of the first format that is present are returned (PNG, TIFF, PGM, NumPy, OpenEXR).
/// @throws Error when the folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> depth_files(const std::filesystem::path& folder);

/// Depth as stored in a file: 16-bit integers in depth units, or floating point in metres.
using StoredDepth = std::variant<DepthImage, Image<float>>;

/// Decodes a TIFF file of one sample per pixel, unsigned 16-bit or 32-bit floating point, in strips.
/// @param file  a whole file, here and below
/// @param source the file's name, for errors, here and below
/// @throws Error when it is damaged, has other contents, or is too large; so do all functions below
[[nodiscard]] StoredDepth decode_tiff(std::span<const std::byte> file, const std::string& source);

/// Decodes a binary PGM file (P5) of more than 8 and up to 16 bits.
[[nodiscard]] StoredDepth decode_pgm(std::span<const std::byte> file, const std::string& source);

/// Decodes a NumPy array of two dimensions in row-major order, little endian: unsigned 16-bit, or 32- or
/// 64-bit floating point. A third dimension of length 1 is allowed.
[[nodiscard]] StoredDepth decode_npy(std::span<const std::byte> file, const std::string& source);

/// Decodes an OpenEXR image in one part, with depth in metres in a channel named Z or depth, in one whose
/// name ends in .Z or .V, or in the only one or the brightness Y.
[[nodiscard]] Image<float> decode_exr(std::span<const std::byte> file, const std::string& source);

/// Reads a depth image; the ending of the file's name selects the format.
/// @param unit_m depth unit of the result, metres, for files in metres; other files are read unchanged
[[nodiscard]] DepthImage read_depth_file(const std::filesystem::path& file, double unit_m);

}  // namespace rva
