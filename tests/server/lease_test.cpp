#include "server/lease.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

const Lease::Holder ann{"client-a", "Ann"};
const Lease::Holder bob{"client-b", "Bob"};

TEST(Lease, IsOnesUntilLetGo) {
  Lease lease;
  EXPECT_FALSE(lease.holder(0));
  EXPECT_TRUE(lease.take(ann, false, 0));
  EXPECT_FALSE(lease.take(bob, false, 1));
  EXPECT_EQ(lease.holder(1)->name, "Ann");
  lease.release(bob.client);
  EXPECT_TRUE(lease.holder(1)) << "a client without the lease cannot release it";
  lease.release(ann.client);
  EXPECT_TRUE(lease.take(bob, false, 2));
}

TEST(Lease, IsTakenOverOnlyWhenAskedTo) {
  Lease lease;
  ASSERT_TRUE(lease.take(ann, false, 0));
  EXPECT_TRUE(lease.take(bob, true, 1));
  EXPECT_FALSE(lease.use(ann.client, 1));
  EXPECT_TRUE(lease.use(bob.client, 1));
}

TEST(Lease, EndsAfterAMinuteWithoutUse) {
  Lease lease;
  ASSERT_TRUE(lease.take(ann, false, 0));
  EXPECT_TRUE(lease.use(ann.client, 59));
  EXPECT_TRUE(lease.holder(118));
  EXPECT_FALSE(lease.holder(119));
  EXPECT_FALSE(lease.use(ann.client, 119)) << "it must be taken anew";
  EXPECT_TRUE(lease.take(bob, false, 119));
}

TEST(Lease, WaitsTenSecondsForAPageThatIsLoadedAgain) {
  Lease lease;
  ASSERT_TRUE(lease.take(ann, false, 0));
  lease.arrive(ann.client);
  EXPECT_TRUE(lease.leave(ann.client, 5));
  EXPECT_TRUE(lease.holder(14));
  lease.arrive(ann.client);
  EXPECT_TRUE(lease.holder(30));
  EXPECT_TRUE(lease.leave(ann.client, 30));
  EXPECT_FALSE(lease.holder(40));
  EXPECT_TRUE(lease.leave(bob.client, 0));
}

TEST(Lease, AClientIsGoneWithItsLastConnection) {
  Lease lease;
  lease.take(ann, false, 0);
  lease.arrive(ann.client);
  lease.arrive(ann.client);
  EXPECT_FALSE(lease.leave(ann.client, 1)) << "it has come back before the old line was known to be dead";
  lease.use(ann.client, 12);
  EXPECT_TRUE(lease.holder(12));
  EXPECT_TRUE(lease.leave(ann.client, 13));
  EXPECT_FALSE(lease.holder(24));
}

}  // namespace
}  // namespace rva
