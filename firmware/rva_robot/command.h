// Commands from the host.
#ifndef RVA_ROBOT_COMMAND_H
#define RVA_ROBOT_COMMAND_H

#include <stdint.h>

#include "limits.h"

namespace rva_robot {

enum class Verb : uint8_t { move, stop, ping, clear, info, lamp, find, name, middle };

/// Why a command is refused.
enum class Refusal : uint8_t { none, crc, form, limit, blind, fault, heat };

struct Command {
  Verb verb = Verb::ping;
  Refusal refusal = Refusal::none;  ///< result of parsing alone
  bool framed = false;              ///< framed commands are answered
  uint8_t number = 0;               ///< number of the frame
  bool moves[axes] = {false, false};
  int16_t target_cdeg[axes] = {0, 0};
  int16_t speed_cdeg_s = fastest_cdeg_s;
  uint8_t lamp_percent = 0;
  uint8_t servo_from = 0;  ///< ID of the servo to be named or turned
  uint8_t servo_to = 0;    ///< its new ID
};

/// Parses the text of a frame between `$` and the end of the line.
Command parse_frame(const char* text, uint8_t length);

/// Parses bare angles in the thesis' format: one command, or two that are run together if there is only one
/// way to read them.
/// @return number of commands; 0 if the text is not valid
uint8_t parse_bare(const char* text, uint8_t length, Command (&commands)[2]);

}  // namespace rva_robot

#endif
