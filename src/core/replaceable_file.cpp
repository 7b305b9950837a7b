#include "core/replaceable_file.hpp"

#include <system_error>

#include "core/output_folder.hpp"
#include "core/path_text.hpp"

namespace rva {

void require_replaceable(const std::filesystem::path& file, bool overwrite) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) return;
  if (overwrite && std::filesystem::is_regular_file(file, failure)) return;
  throw ExistsError(printable(file), "already exists", "choose another name, or replace a file");
}

}  // namespace rva
