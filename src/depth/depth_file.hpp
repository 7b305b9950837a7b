// Depth images in any of the files that people keep them in: PNG, TIFF, PGM, NumPy's arrays.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// The depth images of a folder, by name, as image_files() orders them. Some tools write each image as
/// several files: where there are files of several kinds, those of the first kind count (PNG, TIFF, PGM,
/// NumPy).
/// @throws Error when the folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> depth_files(const std::filesystem::path& folder);

/// Depth as a file holds it: whole units of 16 bits, or metres.
using StoredDepth = std::variant<DepthImage, Image<float>>;

/// A whole file: one sample a pixel, of 16 bits without sign or 32 bits of floating point, in strips.
/// @throws Error when it is damaged, holds something else, or is too large; so do all below
[[nodiscard]] StoredDepth decode_tiff(std::span<const std::byte> file, const std::string& place);

/// Binary (P5), of up to 16 bits.
[[nodiscard]] StoredDepth decode_pgm(std::span<const std::byte> file, const std::string& place);

/// An array of two dimensions, rows first, little endian: of 16 bits without sign, or of 32 or 64 bits of
/// floating point.
[[nodiscard]] StoredDepth decode_npy(std::span<const std::byte> file, const std::string& place);

/// By the file's ending.
/// @param unit_m of the result where the file holds metres; other files are taken as they are
[[nodiscard]] DepthImage read_depth_file(const std::filesystem::path& file, double unit_m);

}  // namespace rva
