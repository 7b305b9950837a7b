#include "cli/printing.hpp"

#include "core/error.hpp"

namespace rva::cli {

void require_printed() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw Error("stdout", "the result cannot be written", "free some space or write to another disk");
  }
}

}  // namespace rva::cli
