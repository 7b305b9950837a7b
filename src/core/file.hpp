// Reading and writing files; every failure is reported.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// Limit of read_file(): no file that RVA reads whole comes near it, and a wrong path must not exhaust
/// the memory.
inline constexpr std::uintmax_t max_file_bytes = 512ULL << 20U;

/// Reads a whole file.
/// @throws Error when the file is missing, unreadable, not a regular file, or larger than max_file_bytes
[[nodiscard]] std::vector<std::byte> read_file(const std::filesystem::path& path);

/// Limit of read_text_file(): descriptions and lists are small, and a parser takes many times the memory of
/// its text.
inline constexpr std::uintmax_t max_text_bytes = 16ULL << 20U;

/// Reads a whole text file. @throws Error as read_file(), but when it is larger than max_text_bytes
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

/// A file that may be too large to be read whole. Reading is const and may run on several threads.
class OpenFile {
 public:
  /// @throws Error when the file is missing, unreadable or not a regular file
  explicit OpenFile(const std::filesystem::path& path);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// The file's size when it was opened.
  [[nodiscard]] std::uint64_t size_bytes() const { return size_bytes_; }

  /// Reads `count` bytes from byte `at` on, or fewer where the file ends. @throws Error when the disk fails
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

/// @overload
void write_file(const std::filesystem::path& path, std::string_view text);

/// Writes a temporary file beside the target and renames it: whatever happens, also a power cut, the target
/// is complete or unchanged. Temporary files that killed programs left beside it are removed.
/// @throws Error when the disk is full or refuses
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// @overload
void replace_file(const std::filesystem::path& path, std::string_view text);

/// Writes the complete file under the name that it is given, and returns when its bytes are on the disk.
using WritesFile = std::function<void(const std::filesystem::path& partial)>;

/// The same for a file that is too large for memory. @throws what `write` throws; nothing is left of the file
void replace_file(const std::filesystem::path& path, const WritesFile& write);

/// Writes a file whole or not at all, as replace_file() does, but neither looks for temporary files of killed
/// programs nor syncs the folder: it is meant for the many files of an OutputFolder, which is removed or made
/// durable as a whole.
void put_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
/// The same for a file that is too large for memory. @throws what `write` throws; nothing is left of the file
void put_file(const std::filesystem::path& path, const WritesFile& write);

/// Appends to a file, which is created where there is none. When it returns, the operating system has the
/// text, but the disk may not have it yet.
/// @throws Error when the disk is full or refuses; part of the text may then be there
void append_to_file(const std::filesystem::path& path, std::string_view text);

}  // namespace rva
