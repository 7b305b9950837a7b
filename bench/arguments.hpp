// The command line of a study.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rva {

/// The arguments of a program by position, without its name; those at the end may be left out.
class Arguments {
 public:
  Arguments(int argc, char** argv) : all_(argv + 1, argv + argc) {}

  [[nodiscard]] std::size_t count() const { return all_.size(); }
  /// @param k from 0  @param otherwise what a missing argument stands for
  [[nodiscard]] std::string at(std::size_t k, const char* otherwise = "") const {
    return k < all_.size() ? all_[k] : otherwise;
  }

 private:
  std::vector<std::string> all_;
};

}  // namespace rva
