#include "cli/config_file.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

std::vector<CLI::ConfigItem> items_of(const std::string& path) {
  std::istringstream text(read_text_file(path));
  try {
    return CLI::ConfigBase().from_config(text);
  } catch (const CLI::Error& error) {
    throw UsageError(printable(path), printable(error.what()), "write one option = value a line");
  }
}

}  // namespace

void apply_config_file(CLI::App& command, const std::string& path) {
  for (const CLI::ConfigItem& item : items_of(path)) {
    const bool is_mark_of_a_section = item.name == "++" || item.name == "--";
    if (is_mark_of_a_section) continue;
    CLI::Option* const option = command.get_option_no_throw("--" + item.name);
    if (option == nullptr || !item.parents.empty())
      throw UsageError(printable(path),
                       printable(item.fullname()) + " is not an option of " + command.get_name(),
                       "see rva " + command.get_name() + " --help");
    if (option->count() > 0) continue;
    try {
      option->add_result(item.inputs);
      option->run_callback();
    } catch (const CLI::Error& error) {
      throw UsageError(printable(path), printable(error.what()), "correct that line");
    }
  }
}

}  // namespace rva::cli
