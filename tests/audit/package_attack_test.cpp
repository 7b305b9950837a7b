#include "bench/attack/package_attack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(PackageAttack, FindsEveryChange) {
  const AttackedPackage attacked = attack_package(2000, 7);
  std::size_t found = 0;
  for (const auto& [name, count] : attacked.kinds) found += count.found;
  EXPECT_THAT(attacked.undetected, testing::IsEmpty());
  EXPECT_EQ(found, 2000U);
  EXPECT_GE(attacked.kinds.size(), 20U);  // no kind is left out
}

}  // namespace
}  // namespace rva
