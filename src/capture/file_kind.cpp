#include "capture/file_kind.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

using namespace std::string_view_literals;

/// A kind of file, recognised by these bytes at this offset.
struct FileKind {
  std::size_t at;
  std::string_view bytes;
  std::string_view name;
  std::string_view remedy;
};

constexpr std::string_view unpack = "unpack it and give the capture that it contains";
constexpr std::string_view give_depth =
    "give the depth images that it was made from, as a capture or a recording";
constexpr std::string_view give_folder = "give the folder of the capture that the image belongs to";
constexpr std::string_view needs_depth = "give a recording of the camera's depth";

constexpr std::array kinds{
    FileKind{0, "version https://git-lfs"sv, "a Git LFS pointer, not the file itself",
             "fetch it with git lfs pull"},
    FileKind{0, "ply\n"sv, "a point cloud (PLY), but depth images are needed", give_depth},
    FileKind{0, "ply\r\n"sv, "a point cloud (PLY), but depth images are needed", give_depth},
    FileKind{0, "# .PCD"sv, "a point cloud (PCD), but depth images are needed", give_depth},
    FileKind{0, "VERSION .7"sv, "a point cloud (PCD), but depth images are needed", give_depth},
    FileKind{0, "PK\x03\x04"sv, "an archive (ZIP)", unpack},
    FileKind{0, "\x1f\x8b"sv, "a packed file (gzip)", unpack},
    FileKind{0, "BZh"sv, "a packed file (bzip2)", unpack},
    FileKind{0, "\xfd\x37zXZ\0"sv, "a packed file (xz)", unpack},
    FileKind{0, "7z\xbc\xaf\x27\x1c"sv, "an archive (7z)", unpack},
    FileKind{257, "ustar"sv, "an archive (tar)", unpack},
    FileKind{4, "ftyp"sv, "a video, which has no depth", needs_depth},
    FileKind{0, "\x1a\x45\xdf\xa3"sv, "a video (Matroska), from which no depth is read", needs_depth},
    FileKind{0, "RIFF"sv, "a video (AVI), which has no depth", needs_depth},
    FileKind{0, "\x89PNG\r\n\x1a\n"sv, "a single image", give_folder},
    FileKind{0, "\xff\xd8\xff"sv, "a single image (JPEG)", give_folder},
    FileKind{0, "II*\0"sv, "a single image (TIFF)", give_folder},
    FileKind{0, "MM\0*"sv, "a single image (TIFF)", give_folder},
    FileKind{0, "\x93NUMPY"sv, "a single array (NumPy)", give_folder},
};

std::string first_bytes(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = 512;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(printable(file), "cannot be read", "check its permissions");
  std::string bytes(most_bytes, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

bool begins_with(const std::filesystem::path& file, std::string_view magic) {
  std::error_code failure;
  return std::filesystem::is_regular_file(file, failure) && first_bytes(file).starts_with(magic);
}

void require_recording(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return;
  const std::string bytes = first_bytes(file);
  if (bytes.empty()) throw Error(printable(file), "the file is empty", "copy or record it again");
  const auto* const kind = std::ranges::find_if(kinds, [&](const FileKind& candidate) {
    return bytes.size() >= candidate.at &&
           std::string_view(bytes).substr(candidate.at).starts_with(candidate.bytes);
  });
  if (kind != kinds.end()) throw Error(printable(file), std::string(kind->name), std::string(kind->remedy));
}

}  // namespace rva
