#include "cli/output_file.hpp"

#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva::cli {

void require_replaceable(const std::filesystem::path& file, bool overwrite) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) return;
  if (overwrite && std::filesystem::is_regular_file(file, failure)) return;
  throw Error(printable(file), "already exists",
              "choose another name, or give --overwrite to replace a file");
}

}  // namespace rva::cli
