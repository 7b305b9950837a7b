#include "cli/console_folder.hpp"

#include <filesystem>

#include "core/error.hpp"

namespace rva::cli {

std::string console_folder() {
  std::error_code failure;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path();
  for (const std::filesystem::path& folder : {here / "console", here.parent_path() / "share/rva/console"}) {
    if (std::filesystem::is_regular_file(folder / "index.html", failure)) return folder.string();
  }
  throw Error("console", "its files were not found beside the program",
              "build it (script/build), or give --console DIR");
}

}  // namespace rva::cli
