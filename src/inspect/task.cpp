#include "inspect/task.hpp"

namespace rva {

std::string_view name_of(TaskKind kind) {
  switch (kind) {
    case TaskKind::readiness:
      return "readiness";
    case TaskKind::capture:
      return "capture";
    case TaskKind::check:
      return "check";
    case TaskKind::comparison:
      return "comparison";
  }
  return "";
}

std::string_view name_of(TaskEnd end) {
  switch (end) {
    case TaskEnd::running:
      return "running";
    case TaskEnd::done:
      return "done";
    case TaskEnd::cancelled:
      return "cancelled";
    case TaskEnd::failed:
      return "failed";
  }
  return "";
}

}  // namespace rva
