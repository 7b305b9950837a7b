// Random changes of a signed package and of the log that it is compared with: all have to be found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rva {

/// What became of the changes of one kind.
struct ChangesOfKind {
  std::size_t found = 0;       ///< changed packages that were refused
  std::size_t undetected = 0;  ///< changed packages that were accepted
};

/// By the name of the kind: `bit`, `byte`, `truncated` ...; `covered` ones had both manifests made anew.
struct AttackedPackage {
  std::map<std::string, ChangesOfKind> kinds;  ///< all changes
  std::vector<std::string> undetected;         ///< a description of each that was accepted
};

/// Changes a small package in as many ways, one at a time, and checks it each time against the public keys
/// and a copy of the log. The same seed gives the same changes.
[[nodiscard]] AttackedPackage attack_package(std::size_t changes, std::uint64_t seed);

}  // namespace rva
