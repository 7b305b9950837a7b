#include "server/conversation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/clock.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

using test::eventually;
using testing::HasSubstr;

constexpr const char* hello = R"({"type":"hello","protocol":1,"client":"0123456789abcdef","name":"Ann"})";

class Talk : public testing::Test {
 protected:
  std::unique_ptr<Conversation> talk(PersonRole role = PersonRole::inspector) {
    auto conversation = std::make_unique<Conversation>(parts_, pictures_, Person{"", role});
    return conversation;
  }
  static double now_s() { return steady_clock().now_s(); }
  static std::vector<Message> all(Conversation& conversation) {
    std::vector<Message> messages;
    while (auto message = conversation.next(now_s())) messages.push_back(std::move(*message));
    return messages;
  }
  static std::shared_ptr<const LivePicture> picture(std::uint64_t number, Stream stream = Stream::color) {
    auto made = std::make_shared<LivePicture>();
    made->stream = stream;
    made->number = number;
    made->jpeg = {std::byte{1}, std::byte{2}};
    return made;
  }
  static Json head(const Message& message) {
    const auto length = static_cast<unsigned char>(message.bytes.at(0));
    return Json::parse(message.bytes.substr(4, length));
  }
  static std::string drive(double pan, double stamp_ms) {
    return Json{{"type", "drive"}, {"pan", pan}, {"tilt", 0.0}, {"stamp_ms", stamp_ms}}.dump();
  }

  test::Served served_;
  ServerParts parts_ = served_.parts();
  LivePictures pictures_{served_.camera, [](const std::shared_ptr<const LivePicture>&) {}};
};

TEST_F(Talk, BeginsWithAHelloOfThisVersion) {
  for (const char* const first :
       {R"({"type":"stop"})", R"({"type":"hello","protocol":2,"client":"0123456789abcdef"})",
        R"({"type":"hello"})", R"({"type":"hello","protocol":1})",
        R"({"type":"hello","protocol":1,"client":"short"})", "", "[]", "x", "{}"})
    EXPECT_THROW(talk()->hear(first, now_s()), ProtocolError) << first;
  const std::string too_long =
      Json{{"type", "hello"}, {"protocol", 1}, {"client", std::string(201, 'c')}}.dump();
  EXPECT_THROW(talk()->hear(too_long, now_s()), ProtocolError)
      << "a client that has not greeted gets no other answer";
  const auto conversation = talk();
  conversation->offer(std::make_shared<const std::string>("status"));
  EXPECT_TRUE(all(*conversation).empty()) << "a client that has not greeted receives nothing";
  conversation->hear(hello, now_s());
  EXPECT_EQ(all(*conversation).back().bytes, "status");
}

TEST_F(Talk, SendsTheNewestPictureWhenTheOneBeforeTheLastIsShown) {
  const auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(R"({"type":"watch","stream":"color"})", now_s());
  static_cast<void>(all(*conversation));
  for (std::uint64_t number = 0; number < 3; ++number) conversation->offer(picture(number));
  std::vector<Message> sent = all(*conversation);
  ASSERT_EQ(sent.size(), 1U) << "what was overtaken is never sent";
  EXPECT_EQ(head(sent[0])["number"], 2);
  EXPECT_TRUE(sent[0].bytes.ends_with("\x01\x02"));
  conversation->offer(picture(3));
  EXPECT_EQ(all(*conversation).size(), 1U);
  conversation->offer(picture(4));
  conversation->offer(picture(5));
  EXPECT_TRUE(all(*conversation).empty()) << "two are under way";
  conversation->hear(R"({"type":"shown"})", now_s());
  sent = all(*conversation);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(head(sent[0])["number"], 5);
  for (int i = 0; i < 50; ++i) conversation->hear(R"({"type":"shown"})", now_s());
  conversation->offer(picture(6));
  conversation->offer(picture(7, Stream::depth));
  EXPECT_EQ(all(*conversation).size(), 1U) << "of the stream that is watched";
}

TEST_F(Talk, TheHolderOfTheLeaseDrivesAndStopsWhenGone) {
  auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(drive(1.0, 0), now_s());
  EXPECT_THAT(all(*conversation).at(0).bytes, HasSubstr("not-driving"));
  conversation->hear(R"({"type":"lease","action":"take"})", now_s());
  EXPECT_THAT(all(*conversation).at(0).bytes, HasSubstr("\"yours\":true"));
  ASSERT_TRUE(eventually([&] {
    conversation->hear(drive(1.0, 1000.0 * now_s()), now_s());
    return served_.drive.state().driving;
  }));
  conversation.reset();
  EXPECT_TRUE(eventually([&] { return !served_.drive.state().driving; }));
  EXPECT_FALSE(served_.drive.state().armed);
}

TEST_F(Talk, OldNewsOfSticksDoesNotDrive) {
  const auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(R"({"type":"lease","action":"take"})", now_s());
  conversation->hear(drive(0.0, 1000.0 * now_s()), now_s());
  // What lay in a queue for a second, all at once.
  for (int i = 0; i < 20; ++i) {
    const double now = now_s();
    conversation->hear(drive(1.0, 1000.0 * now - 1000.0), now);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_FALSE(served_.drive.state().driving);
  ASSERT_TRUE(eventually([&] {
    conversation->hear(drive(1.0, 1000.0 * now_s()), now_s());
    return served_.drive.state().driving;
  })) << "fresh ones do";
}

TEST_F(Talk, AStopIsEverybodys) {
  const auto driver = talk();
  driver->hear(hello, now_s());
  driver->hear(R"({"type":"lease","action":"take"})", now_s());
  ASSERT_TRUE(eventually([&] {
    driver->hear(drive(1.0, 1000.0 * now_s()), now_s());
    return served_.drive.state().driving;
  }));
  const auto viewer = talk(PersonRole::viewer);
  viewer->hear(R"({"type":"hello","protocol":1,"client":"fedcba9876543210","name":"Bob"})", now_s());
  viewer->hear(R"({"type":"stop"})", now_s());
  EXPECT_TRUE(eventually([&] { return !served_.drive.state().driving && !served_.drive.state().armed; }));
}

TEST_F(Talk, AStopEndsACaptureThatWouldMoveTheRobotOn) {
  ASSERT_TRUE(eventually([&] { return served_.drive.state().joints.has_value(); }));
  const std::int64_t id = served_.inspector.begin({"", "", "", "Ann"});
  served_.inspector.set_views(id, {{0, 0}, {20, 0}});
  served_.inspector.capture(id, Side::initial, "Ann", false);
  const auto viewer = talk(PersonRole::viewer);
  viewer->hear(R"({"type":"hello","protocol":1,"client":"fedcba9876543210","name":"Bob"})", now_s());
  viewer->hear(R"({"type":"stop"})", now_s());
  EXPECT_TRUE(eventually([&] { return served_.inspector.task().end == TaskEnd::cancelled; }));
  EXPECT_FALSE(served_.inspector.inspection(id).initial);
}

TEST_F(Talk, HandingBackTheControlsArmsNothing) {
  const auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(R"({"type":"lease","action":"take"})", now_s());
  ASSERT_TRUE(eventually([&] {
    conversation->hear(drive(1.0, 1000.0 * now_s()), now_s());
    return served_.drive.state().driving;
  }));
  conversation->hear(R"({"type":"stop"})", now_s());
  conversation->hear(R"({"type":"lease","action":"release"})", now_s());
  conversation->hear(R"({"type":"lease","action":"take"})", now_s());
  ASSERT_TRUE(eventually([&] { return !served_.drive.state().driving; }));
  for (int i = 0; i < 20; ++i) {
    conversation->hear(drive(1.0, 1000.0 * now_s()), now_s());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(served_.drive.state().driving) << "the stick was not let go";
  }
}

TEST_F(Talk, APersonWhoMayNoLongerDriveDoesNot) {
  const auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(R"({"type":"lease","action":"take"})", now_s());
  ASSERT_TRUE(eventually([&] {
    conversation->hear(drive(1.0, 1000.0 * now_s()), now_s());
    return served_.drive.state().driving;
  }));
  conversation->set_role(PersonRole::viewer);
  EXPECT_FALSE(served_.lease.holder(now_s()));
  EXPECT_TRUE(eventually([&] { return !served_.drive.state().driving; }));
}

TEST_F(Talk, TheControlsAloneDoNotMakeAViewerDrive) {
  const auto viewer = talk(PersonRole::viewer);
  viewer->hear(hello, now_s());
  served_.lease.take({"0123456789abcdef", "Ann"}, false, now_s());
  viewer->hear(drive(1.0, 1000.0), now_s());
  EXPECT_THAT(all(*viewer).front().bytes, HasSubstr("not-driving"));
  EXPECT_FALSE(served_.drive.state_after_asking().driving);
}

TEST_F(Talk, TheLeaseIsTakenOverWhenAskedAndNotByAViewer) {
  const auto ann = talk();
  ann->hear(hello, now_s());
  ann->hear(R"({"type":"lease","action":"take"})", now_s());
  const auto bob = talk();
  bob->hear(R"({"type":"hello","protocol":1,"client":"fedcba9876543210","name":"Bob"})", now_s());
  bob->hear(R"({"type":"lease","action":"take"})", now_s());
  EXPECT_THAT(all(*bob).at(0).bytes, HasSubstr("somebody-drives"));
  bob->hear(R"({"type":"lease","action":"take-over"})", now_s());
  EXPECT_THAT(all(*ann).back().bytes, HasSubstr("\"holder\":\"Bob\""));
  const auto viewer = talk(PersonRole::viewer);
  viewer->hear(R"({"type":"hello","protocol":1,"client":"aaaaaaaaaaaaaaaa"})", now_s());
  viewer->hear(R"({"type":"lease","action":"take-over"})", now_s());
  EXPECT_THAT(all(*viewer).at(0).bytes, HasSubstr("not-allowed"));
}

TEST_F(Talk, FloodsAndNonsenseEndIt) {
  const auto conversation = talk();
  conversation->hear(hello, 0.0);
  EXPECT_THROW(conversation->hear(R"({"type":"dance"})", 0.0), ProtocolError);
  EXPECT_THROW(conversation->hear(R"({"type":7})", 0.0), ProtocolError);
  EXPECT_THROW(
      {
        for (int i = 0; i < 1000; ++i) conversation->hear(R"({"type":"shown"})", 0.5);
      },
      ProtocolError);
}

TEST_F(Talk, ABadNumberIsRefusedAndTheTalkGoesOn) {
  const auto conversation = talk();
  conversation->hear(hello, now_s());
  conversation->hear(R"({"type":"drive","pan":"left","tilt":0,"stamp_ms":0})", now_s());
  EXPECT_THAT(all(*conversation).at(0).bytes, HasSubstr("bad-request"));
}

TEST_F(Talk, AViewerPointsToo) {
  const auto viewer = talk(PersonRole::viewer);
  viewer->hear(hello, 1.0);
  viewer->hear(
      R"({"type":"pointing","stream":"color","shape":"arrow","from":{"x":0,"y":1},"to":{"x":0.5,"y":0.5},"note":"x"})",
      1.0);
  const std::shared_ptr<const std::string> pointed = viewer->take_pointed();
  ASSERT_TRUE(pointed);
  EXPECT_EQ(*pointed, R"({"type":"pointed","name":"Ann","stream":"color","shape":"arrow",)"
                      R"("from":{"x":0.0,"y":1.0},"to":{"x":0.5,"y":0.5}})")
      << "nothing else is passed on";
  EXPECT_FALSE(viewer->take_pointed());
}

TEST_F(Talk, PointingIsLimitedInRateAndSize) {
  const std::string tap = R"({"type":"pointing","stream":"color","shape":"tap","from":{"x":0.5,"y":0.5}})";
  const auto conversation = talk();
  conversation->hear(hello, 1.0);
  int passed = 0;
  for (int i = 0; i < 20; ++i) {
    conversation->hear(tap, 1.0);
    if (conversation->take_pointed()) ++passed;
  }
  EXPECT_EQ(passed, 6) << "as many as in two seconds";
  EXPECT_THAT(all(*conversation).at(0).bytes, HasSubstr("too-many"));
  conversation->hear(tap, 1.4);
  EXPECT_TRUE(conversation->take_pointed()) << "again after a moment";
  for (int i = 0; i < 30; ++i) conversation->offer_pointed(std::make_shared<const std::string>("{}"));
  EXPECT_EQ(
      std::ranges::count_if(all(*conversation), [](const Message& message) { return message.bytes == "{}"; }),
      20)
      << "a slow console gets the last ones";
}

TEST_F(Talk, MalformedPointingIsRefused) {
  const auto conversation = talk();
  conversation->hear(hello, 1.0);
  double now_s = 2.0;
  for (const char* const bad :
       {R"({"type":"pointing"})",
        R"({"type":"pointing","stream":"sonar","shape":"tap","from":{"x":0,"y":0}})",
        R"({"type":"pointing","stream":"color","shape":"star","from":{"x":0,"y":0}})",
        R"({"type":"pointing","stream":"color","shape":"tap"})",
        R"({"type":"pointing","stream":"color","shape":"tap","from":{"x":1.1,"y":0}})",
        R"({"type":"pointing","stream":"color","shape":"circle","from":{"x":1,"y":0}})",
        R"({"type":"pointing","stream":"color","shape":"tap","from":[1,2]})"}) {
    conversation->hear(bad, now_s += 1.0);
    EXPECT_FALSE(conversation->take_pointed()) << bad;
    EXPECT_THAT(all(*conversation).at(0).bytes, HasSubstr("bad-request")) << bad;
  }
}

}  // namespace
}  // namespace rva
