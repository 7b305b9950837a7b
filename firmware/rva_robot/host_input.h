// Splits the bytes from the host into commands.
#ifndef RVA_ROBOT_HOST_INPUT_H
#define RVA_ROBOT_HOST_INPUT_H

#include <stdint.h>

#include "command.h"

namespace rva_robot {

class HostInput {
 public:
  static constexpr uint8_t longest_frame = 48;      ///< including `$` and the end of the line
  static constexpr uint8_t silence_ends_ms = 10;    ///< silence of this length ends a bare command
  static constexpr uint8_t longest_bare_text = 16;  ///< for two commands run together

  /// Takes a byte; next() returns the commands that it completes.
  void take(uint8_t byte, uint32_t now_ms);

  /// Ends a bare command after silence.
  void tick(uint32_t now_ms);

  /// Returns the next command.
  /// @return false if there is none
  bool next(Command& command);

  /// Whether a valid frame was received. From then on, bare angles are ignored.
  bool framed() const { return framed_; }

 private:
  void take_in_frame(char character);
  void take_bare(char character);
  void end_bare();
  void keep(const Command& command);

  char text_[longest_frame] = {};
  uint8_t size_ = 0;
  bool in_frame_ = false;
  bool too_long_ = false;
  bool junk_ = false;  // the current bare command contains invalid characters
  bool framed_ = false;
  uint32_t last_byte_ms_ = 0;
  Command waiting_[2];
  uint8_t first_ = 0;
  uint8_t count_ = 0;
};

}  // namespace rva_robot

#endif
