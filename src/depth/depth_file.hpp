// Depth images in any of the files that people keep them in: PNG, TIFF, PGM, NumPy's arrays.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// Endings of the files that are read, in lower case.
[[nodiscard]] const std::vector<std::string_view>& depth_endings();

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
