#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace rva {

Error::Error(std::string source, std::string problem, std::string remedy)
    : std::runtime_error(fmt::format("{}: {}; {}", source, problem, remedy)),
      source_(std::move(source)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

}  // namespace rva
