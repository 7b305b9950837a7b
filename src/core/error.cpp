#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace rva {

Error::Error(std::string place, std::string problem, std::string remedy)
    : std::runtime_error(fmt::format("{}: {}; {}", place, problem, remedy)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

}  // namespace rva
