// Counts which of many random changes of a signed package are found.
//   rva_package_attack [CHANGES [SEED]]: 100000 and 1 by default; status 1 if one was undetected
#include <fmt/format.h>

#include <cstdlib>

#include "bench/attack/package_attack.hpp"

int main(int argc, char** argv) {
  const std::size_t changes = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const rva::AttackedPackage attacked = rva::attack_package(changes, seed);
  fmt::print("{:28} {:>9} {:>11}\n", "change", "found", "undetected");
  rva::ChangesOfKind all;
  for (const auto& [name, count] : attacked.kinds) {
    fmt::print("{:28} {:9} {:11}\n", name, count.found, count.undetected);
    all.found += count.found;
    all.undetected += count.undetected;
  }
  fmt::print("{:28} {:9} {:11}\n", "all", all.found, all.undetected);
  for (const std::string& description : attacked.undetected) fmt::print("undetected: {}\n", description);
  return attacked.undetected.empty() ? 0 : 1;
}
