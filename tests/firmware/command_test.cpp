#include "firmware/rva_robot/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "firmware/rva_robot/host_input.h"
#include "firmware/rva_robot/text.h"
#include "tests/firmware/golden_lines.hpp"

namespace rva::test {
namespace {

using rva_robot::Command;
using rva_robot::HostInput;
using rva_robot::Line;
using rva_robot::Refusal;
using rva_robot::Verb;

std::string frame(const std::string& text) {
  return fmt::format("${}*{:04X}\n", text,
                     rva_robot::crc16(text.data(), static_cast<std::uint8_t>(text.size())));
}

/// What comes of bytes that arrive at once, and of the silence after them.
std::vector<Command> commands_of(const std::string& bytes, HostInput input = {}) {
  std::vector<Command> commands;
  Command command;
  const auto collect = [&] {
    while (input.next(command)) commands.push_back(command);
  };
  for (const char byte : bytes) {
    input.take(static_cast<std::uint8_t>(byte), 0);
    collect();
  }
  input.tick(HostInput::silence_ends_ms);
  collect();
  return commands;
}

Command only_command_of(const std::string& bytes) {
  const std::vector<Command> commands = commands_of(bytes);
  EXPECT_EQ(commands.size(), 1U) << bytes;
  return commands.size() == 1 ? commands[0] : Command{};
}

TEST(Frames, GoldenLinesOfTheHostAreUnderstood) {
  const std::vector<std::string> lines = golden_lines("host");
  ASSERT_EQ(lines.size(), 10U);
  std::vector<Verb> verbs;
  for (const std::string& line : lines) {
    const Command command = only_command_of(line + "\n");
    EXPECT_EQ(command.refusal, Refusal::none) << line;
    EXPECT_TRUE(command.framed);
    verbs.push_back(command.verb);
  }
  EXPECT_EQ(verbs, (std::vector{Verb::ping, Verb::move, Verb::move, Verb::stop, Verb::clear, Verb::info,
                                Verb::lamp, Verb::find, Verb::name, Verb::middle}));
  EXPECT_EQ(only_command_of(lines[6] + "\n").lamp_percent, 40);
  EXPECT_EQ(only_command_of(lines[8] + "\n").servo_from, 253);
  EXPECT_EQ(only_command_of(lines[8] + "\n").servo_to, 1);
  const Command slow = only_command_of(lines[2] + "\r\n");
  EXPECT_EQ(slow.number, 2);
  EXPECT_EQ(slow.target_cdeg[0], -9000);
  EXPECT_EQ(slow.target_cdeg[1], 900);
  EXPECT_EQ(slow.speed_cdeg_s, 1250);
}

TEST(Frames, GoldenLinesOfTheRobotHaveItsChecksums) {
  const std::vector<std::string> lines = golden_lines("robot");
  ASSERT_EQ(lines.size(), 14U);
  for (const std::string& line : lines) {
    Line built;
    built.text(line.substr(1, line.size() - 6).c_str()).close_frame();
    EXPECT_TRUE(built.sound());
    EXPECT_EQ(std::string(built.data(), built.size()), line + "\r\n");
  }
}

TEST(Frames, GoldenLinesAreThoseOfTheProtocolsPage) {
  std::ifstream file(RVA_PROTOCOL_PAGE);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const std::string direction : {"host", "robot"}) {
    for (const std::string& line : golden_lines(direction))
      EXPECT_NE(page.find(fmt::format("    {} {}\n", direction, line)), std::string::npos) << line;
  }
}

TEST(Frames, WhatIsNoCommandIsRefusedWithItsReason) {
  const std::map<std::string, Refusal> texts{{"1 MOVE 90.01 0", Refusal::limit},
                                             {"1 MOVE 0 9.01", Refusal::limit},
                                             {"1 MOVE -90.01 0", Refusal::limit},
                                             {"1 MOVE 0 0 90.01", Refusal::limit},
                                             {"1 MOVE 0 0 0.99", Refusal::limit},
                                             {"1 LAMP 101", Refusal::limit},
                                             {"1 LAMP 256", Refusal::form},
                                             {"1 LAMP -1", Refusal::form},
                                             {"1 LAMP 4.5", Refusal::form},
                                             {"1 NAME 253 254", Refusal::limit},
                                             {"1 NAME 254 1", Refusal::limit},
                                             {"1 MIDDLE 254", Refusal::limit},
                                             {"1 MIDDLE", Refusal::form},
                                             {"1 NAME 1", Refusal::form},
                                             {"1 NAME 1 2 3", Refusal::form},
                                             {"1 FIND 1", Refusal::form},
                                             {"1 LAMP", Refusal::form},
                                             {"1 LAMP 4 4", Refusal::form},
                                             {"1 MOVE 0", Refusal::form},
                                             {"1 MOVE 0 0 10 10", Refusal::form},
                                             {"1 MOVE 0  0", Refusal::form},
                                             {"1 MOVE 0 0 ", Refusal::form},
                                             {"1 MOVE 1e1 0", Refusal::form},
                                             {"1 MOVE 0.001 0", Refusal::form},
                                             {"1 MOVE +1 0", Refusal::form},
                                             {"1 MOVE . 0", Refusal::form},
                                             {"1 MOVE 1. 0", Refusal::form},
                                             {"1 MOVE 99999 0", Refusal::form},
                                             {"1 move 0 0", Refusal::form},
                                             {"1 STOP now", Refusal::form},
                                             {"256 STOP", Refusal::form},
                                             {"-1 STOP", Refusal::form},
                                             {"STOP", Refusal::form},
                                             {"", Refusal::form},
                                             {"1", Refusal::form}};
  for (const auto& [text, refusal] : texts) EXPECT_EQ(only_command_of(frame(text)).refusal, refusal) << text;
}

TEST(Frames, AnyFlippedBitIsNoticed) {
  const std::string good = frame("17 MOVE 12.25 -40.5 30");
  for (std::size_t i = 1; i + 1 < good.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ (1 << bit));
      for (const Command& command : commands_of(bad)) {
        const bool harmless = command.refusal != Refusal::none || command.verb == Verb::stop;
        EXPECT_TRUE(harmless) << bad;
      }
    }
  }
}

TEST(Frames, OneBeginsAnywhereAndTooLongOnesAreDropped) {
  EXPECT_EQ(only_command_of("12.$9 PI" + frame("3 PING")).number, 3);
  EXPECT_EQ(only_command_of("$" + std::string(300, '7') + "\n" + frame("4 PING")).number, 4);
  EXPECT_EQ(only_command_of("$" + std::string(300, '7') + frame("5 PING")).number, 5);
}

TEST(Frames, AStopGetsThroughInTheMiddleOfOne) {
  std::vector<Command> commands = commands_of("$9 MOVE 10 !-10");
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].verb, Verb::stop);
  commands = commands_of("45.10!");
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].verb, Verb::stop);
}

std::string moves_of(const Command& command) {
  const auto half = [&](int axis) {
    return command.moves[axis] ? std::to_string(command.target_cdeg[axis] / 100) : std::string("-");
  };
  return half(0) + " " + half(1);
}

std::vector<std::string> moves_of(const std::vector<Command>& commands) {
  std::vector<std::string> all;
  for (const Command& command : commands) all.push_back(moves_of(command));
  return all;
}

TEST(BareAngles, AreTheThesisOnes) {
  using Moves = std::vector<std::string>;
  const std::map<std::string, Moves> texts{
      {"45.-10", {"45 -10"}},   {"45.", {"45 -"}},          {".-10", {"- -10"}}, {"-90.9", {"-90 9"}},
      {"45.-10\n", {"45 -10"}}, {"45.-10\r\n", {"45 -10"}}, {"05.3", {"5 3"}}};
  for (const auto& [text, commands] : texts) EXPECT_EQ(moves_of(commands_of(text)), commands) << text;
}

TEST(BareAngles, WhatTheThesisFirmwareMisreadIsReadOrRefused) {
  for (const std::string text : {"hello", "\n", "\r\n", "20.5.-10.5", "45.10", "91.0", ".", "5", "--5.3",
                                 "4-5.3", "1234.5", "1.2.3.4", "45 .3", "10.20.30"})
    EXPECT_TRUE(commands_of(text).empty()) << text;
  EXPECT_EQ(moves_of(commands_of("45.550.-20")), (std::vector<std::string>{"45 5", "50 -20"}));
  EXPECT_EQ(moves_of(commands_of("45.-1050.-20")), (std::vector<std::string>{"45 -10", "50 -20"}));
}

TEST(BareAngles, HalfOfOneIsNotTheWhole) {
  HostInput input;
  Command command;
  std::vector<Command> commands;
  std::uint32_t now_ms = 0;
  for (const std::string part : {"50.", "5"}) {
    for (const char byte : part) input.take(static_cast<std::uint8_t>(byte), now_ms);
    now_ms += 20;
    input.tick(now_ms);
    while (input.next(command)) commands.push_back(command);
  }
  EXPECT_EQ(moves_of(commands), std::vector<std::string>{"50 -"}) << "and no pan of 5";
}

TEST(BareAngles, AreNotTakenAfterTheFirstGoodFrame) {
  EXPECT_EQ(commands_of(frame("1 PING") + "45.3").size(), 1U);
  EXPECT_EQ(moves_of(commands_of("$1 PONG*0000\n45.3")).back(), "45 3")
      << "one that is damaged does not count";
}

}  // namespace
}  // namespace rva::test
