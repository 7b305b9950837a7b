#include "firmware/rva_robot/herkulex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace rva::test {
namespace {

using rva_robot::Packet;
using rva_robot::PacketReader;

std::vector<std::uint8_t> bytes_of(const Packet& packet) {
  std::uint8_t bytes[rva_robot::longest_packet];
  const std::uint8_t size = rva_robot::encode(packet, bytes);
  return {bytes, bytes + size};
}

Packet read_request() {
  Packet packet;
  packet.id = 2;
  packet.command = rva_robot::herkulex::ram_read;
  packet.add(58);
  packet.add(2);
  return packet;
}

TEST(Herkulex, PacketsAreThoseOfTheManual) {
  // An answer to STAT as captured from a servo.
  Packet stat;
  stat.id = 0xFD;
  stat.command = 0x47;
  stat.add(0);
  stat.add(0);
  EXPECT_EQ(bytes_of(stat),
            (std::vector<std::uint8_t>{0xFF, 0xFF, 0x09, 0xFD, 0x47, 0xB2, 0x4C, 0x00, 0x00}));
}

TEST(Herkulex, AnglesAreCountsOfAThirdOfADegree) {
  for (std::uint16_t count = 21; count <= 1002; ++count) {
    const std::int16_t cdeg = rva_robot::cdeg_of_count(count);
    EXPECT_LE(std::abs(cdeg - 32.5 * (count - 512)), 0.5);
    EXPECT_EQ(rva_robot::count_of_cdeg(cdeg), count);
  }
  for (int cdeg = -9000; cdeg <= 9000; ++cdeg) {
    const int count = rva_robot::count_of_cdeg(static_cast<std::int16_t>(cdeg));
    EXPECT_LE(std::abs(32.5 * (count - 512) - cdeg), 17.0) << cdeg;
  }
}

TEST(Herkulex, PacketsAreFoundInNoise) {
  std::mt19937 random(5);
  const std::vector<std::uint8_t> packet = bytes_of(read_request());
  PacketReader reader;
  Packet found;
  int sound = 0;
  for (int i = 0; i < 2000; ++i) {
    for (auto k = random() % 40; k > 0; --k) reader.take(static_cast<std::uint8_t>(random()), found);
    // Noise may have begun a packet that swallows the first that follows, never the third.
    bool seen = false;
    for (int copy = 0; copy < 4; ++copy) {
      for (const std::uint8_t byte : packet) seen = reader.take(byte, found) || seen;
    }
    sound += seen && found.id == 2 && found.length == 2 && found.data[0] == 58 ? 1 : 0;
  }
  EXPECT_EQ(sound, 2000);
}

TEST(Herkulex, DamagedPacketsArePassedOver) {
  const std::vector<std::uint8_t> good = bytes_of(read_request());
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (int bit = 1; bit < 8; ++bit) {  // the lowest one of a byte is not in the servos' checksum
      std::vector<std::uint8_t> bad = good;
      bad[i] = static_cast<std::uint8_t>(bad[i] ^ (1U << bit));
      PacketReader reader;
      Packet found;
      for (const std::uint8_t byte : bad) EXPECT_FALSE(reader.take(byte, found)) << i << " " << bit;
    }
  }
}

}  // namespace
}  // namespace rva::test
