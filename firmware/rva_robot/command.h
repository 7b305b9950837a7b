// What a host asks for.
#ifndef RVA_ROBOT_COMMAND_H
#define RVA_ROBOT_COMMAND_H

#include <stdint.h>

#include "limits.h"

namespace rva_robot {

enum class Verb : uint8_t { move, stop, ping, clear, info };

/// Why a command is not taken.
enum class Refusal : uint8_t { none, crc, form, limit, blind, fault };

struct Command {
  Verb verb = Verb::ping;
  Refusal refusal = Refusal::none;  ///< by its form alone
  bool framed = false;              ///< and so waits for an answer
  uint8_t number = 0;               ///< of the frame
  bool moves[axes] = {false, false};
  int16_t target_cdeg[axes] = {0, 0};
  int16_t speed_cdeg_s = fastest_cdeg_s;
};

/// A frame's text between `$` and the end of the line.
Command parse_frame(const char* text, uint8_t length);

/// Bare angles of the thesis: one command, or two run together where there is one way only to read them.
/// @return how many commands, 0 where it is none
uint8_t parse_bare(const char* text, uint8_t length, Command (&commands)[2]);

}  // namespace rva_robot

#endif
