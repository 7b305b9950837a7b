#include "server/console_files.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::string content_type_of(const fs::path& file) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> types{{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".woff2", "font/woff2"},
      {".json", "application/json"},
  }};
  for (const auto& [ending, type] : types) {
    if (file.extension() == ending) return std::string(type);
  }
  return "application/octet-stream";
}

std::string text_of(const fs::path& file) {
  const std::vector<std::byte> bytes = read_file(file);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

ConsoleFiles::ConsoleFiles(const fs::path& folder) {
  std::error_code failure;
  if (!fs::is_regular_file(folder / "index.html", failure))
    throw Error(printable(folder), "contains no console",
                "build it (script/build), or choose another folder");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, failure)) {
    const fs::path& file = entry.path();
    if (!entry.is_regular_file() || file.extension() == ".gz") continue;
    const std::string name = "/" + file.lexically_relative(folder).generic_string();
    ConsoleFile read{content_type_of(file), text_of(file), {}, name.starts_with("/assets/")};
    const fs::path compressed = file.string() + ".gz";
    if (fs::is_regular_file(compressed, failure)) read.gzip = text_of(compressed);
    files_[name] = std::move(read);
  }
  files_["/"] = files_.at("/index.html");
}

const ConsoleFile* ConsoleFiles::find(const std::string& path) const {
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : &found->second;
}

}  // namespace rva
