#include "server/live_hub.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/clock.hpp"
#include "tests/eventually.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

constexpr const char* hello = R"({"type":"hello","protocol":1,"client":"0123456789abcdef","name":"Ann"})";

class LiveHubTest : public testing::Test {
 protected:
  std::shared_ptr<LiveHub::Member> join() {
    std::shared_ptr<LiveHub::Member> member = hub_.join({"", PersonRole::inspector});
    member->conversation.hear(hello, steady_clock().now_s());
    return member;
  }
  void begin_to_tell() {
    asio::co_spawn(context_, hub_.tell_status(), [this](const std::exception_ptr&) { told_ = true; });
  }
  static std::vector<Message> messages(LiveHub::Member& member) {
    std::vector<Message> messages;
    while (auto message = member.conversation.next(steady_clock().now_s()))
      messages.push_back(std::move(*message));
    return messages;
  }
  /// Runs the context until the member is sent a status; the status, or null.
  Json next_status(LiveHub::Member& member) {
    Json status;
    EXPECT_TRUE(test::eventually([&] {
      context_.poll();
      for (const Message& message : messages(member)) {
        if (message.binary) continue;
        Json json = Json::parse(message.bytes);
        if (json["type"] == "status") status = std::move(json);
      }
      return !status.is_null();
    }));
    return status;
  }

  asio::io_context context_;
  test::Served served_;
  ServerParts parts_ = served_.parts();
  bool told_ = false;
  LiveHub hub_{context_, parts_};
};

TEST_F(LiveHubTest, TellsTheStatusToEveryConsole) {
  const auto ann = join();
  const auto bob = join();
  begin_to_tell();
  EXPECT_EQ(next_status(*ann)["consoles"], 2);
  EXPECT_EQ(next_status(*bob)["consoles"], 2);
  hub_.leave(bob);
  EXPECT_TRUE(test::eventually([&] { return next_status(*ann)["consoles"] == 1; }));
  hub_.end();
  context_.run();
  EXPECT_TRUE(told_);
}

TEST_F(LiveHubTest, TellsWhoeverJoinsTheLastStatusAtOnce) {
  const auto ann = join();
  begin_to_tell();
  next_status(*ann);
  const auto bob = join();
  bool known = false;
  for (const Message& message : messages(*bob))
    known = known || Json::parse(message.bytes)["type"] == "status";
  EXPECT_TRUE(known) << "without waiting for the next one";
}

// Silence shows a console that its connection is broken.
TEST_F(LiveHubTest, RepeatsAStatusThatDoesNotChange) {
  served_.plug->pulled = true;
  ASSERT_TRUE(test::eventually([&] { return !served_.camera.health().problem.empty(); }));
  const auto ann = join();
  begin_to_tell();
  const Json first = next_status(*ann);
  EXPECT_EQ(next_status(*ann), first);
}

TEST_F(LiveHubTest, WakesTheSenderWhenThereIsSomethingToSend) {
  const auto ann = join();
  bool woken = false;
  ann->alarm.expires_after(std::chrono::hours(1));
  ann->alarm.async_wait([&](const ErrorCode& failure) { woken = failure == asio::error::operation_aborted; });
  begin_to_tell();
  EXPECT_TRUE(test::eventually([&] {
    context_.poll();
    return woken;
  }));
}

TEST_F(LiveHubTest, PassesPicturesToTheConsolesThatWatchThem) {
  const auto ann = join();
  const auto bob = join();
  begin_to_tell();
  ann->conversation.hear(R"({"type":"watch","stream":"depth"})", steady_clock().now_s());
  std::optional<Message> picture;
  EXPECT_TRUE(test::eventually([&] {
    context_.poll();
    for (Message& message : messages(*ann))
      if (message.binary) picture = std::move(message);
    return picture.has_value();
  }));
  EXPECT_THAT(picture.value_or(Message{}).bytes, testing::HasSubstr("depth"));
  for (const Message& message : messages(*bob)) EXPECT_FALSE(message.binary);
}

TEST_F(LiveHubTest, EndsTheTimersOfAMemberThatEnds) {
  const auto ann = join();
  int ended = 0;
  for (auto* const timer : {&ann->alarm, &ann->next_check}) {
    timer->expires_after(std::chrono::hours(1));
    timer->async_wait([&](const ErrorCode&) { ++ended; });
  }
  ann->end();
  context_.run();
  EXPECT_EQ(ended, 2);
  EXPECT_TRUE(ann->ended);
}

TEST_F(LiveHubTest, WhatAPersonPointsAtIsShownToAll) {
  const auto ann = join();
  const auto bob = join();
  ann->conversation.hear(
      R"({"type":"pointing","stream":"depth","shape":"tap","from":{"x":0.5,"y":0.25},"to":{"x":0.5,"y":0.25}})",
      steady_clock().now_s());
  hub_.pass_on_pointing(*ann);
  hub_.pass_on_pointing(*ann);
  for (LiveHub::Member* const member : {ann.get(), bob.get()}) {
    int pointed = 0;
    for (const Message& message : messages(*member)) {
      const Json json = Json::parse(message.bytes);
      if (json["type"] != "pointed") continue;
      ++pointed;
      EXPECT_EQ(json["name"], "Ann");
      EXPECT_EQ(json["from"]["y"], 0.25);
    }
    EXPECT_EQ(pointed, 1);
  }
}

}  // namespace
}  // namespace rva
