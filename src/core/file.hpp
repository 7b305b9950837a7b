// Whole files, in and out, with every failure reported.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// Larger files are refused: no file that RVA reads whole comes near it, and a mistaken path must not fill
/// the memory.
inline constexpr std::uintmax_t max_file_bytes = 512ULL << 20U;

/// @throws Error when the file is missing, unreadable, not a regular file, or larger than max_file_bytes
[[nodiscard]] std::vector<std::byte> read_file(const std::filesystem::path& path);

/// Descriptions and lists are small; a parser takes many times the memory of its text.
inline constexpr std::uintmax_t max_text_bytes = 16ULL << 20U;

/// As read_file(), as text, up to max_text_bytes.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

/// A file that may be too large to be read whole. Reading is const and may run on several threads.
class OpenFile {
 public:
  /// @throws Error as read_file(), but of any size
  explicit OpenFile(const std::filesystem::path& path);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// When it was opened.
  [[nodiscard]] std::uint64_t size_bytes() const { return size_bytes_; }

  /// As many bytes as there are from `at` on, at most `count`. @throws Error when the disk fails
  [[nodiscard]] std::vector<std::byte> read(std::uint64_t at, std::size_t count) const;

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_bytes_ = 0;
};

/// Creates or replaces the file, and returns when its bytes are on the disk (fsync).
/// @throws Error when the disk is full or refuses; the file may then be incomplete, so write into a folder
///         that is renamed at the end (OutputFolder).
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// The same by way of a file beside it that takes its place: it is there whole, or as it was before, and
/// stays so through a power cut. Files beside it that killed programs left are removed.
/// @throws Error when the disk is full or refuses
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void replace_file(const std::filesystem::path& path, std::string_view text);

/// Writes a file whole or not at all, as replace_file() does, but does not look for files that killed
/// programs left: it is meant for the many files of an OutputFolder, which is removed or made durable as a
/// whole.
void put_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Adds to the end of a file, and makes the file where there is none. When it returns, the system has the
/// text, the disk perhaps not yet.
/// @throws Error when the disk is full or refuses; part of the text may then be there
void append_to_file(const std::filesystem::path& path, std::string_view text);

}  // namespace rva
