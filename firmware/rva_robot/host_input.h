// Bytes from the host, cut into commands.
#ifndef RVA_ROBOT_HOST_INPUT_H
#define RVA_ROBOT_HOST_INPUT_H

#include <stdint.h>

#include "command.h"

namespace rva_robot {

class HostInput {
 public:
  static constexpr uint8_t longest_frame = 48;      ///< with `$` and end
  static constexpr uint8_t silence_ends_ms = 10;    ///< a bare command
  static constexpr uint8_t longest_bare_text = 16;  ///< two commands run together

  /// Takes a byte; the commands that it completes are what next() gives.
  void take(uint8_t byte, uint32_t now_ms);

  /// Ends a bare command that silence has ended.
  void tick(uint32_t now_ms);

  /// @return false when there is none
  bool next(Command& command);

  /// From the first good frame on, bare angles are taken no more.
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
  bool junk_ = false;  // in a bare command
  bool framed_ = false;
  uint32_t last_byte_ms_ = 0;
  Command waiting_[2];
  uint8_t first_ = 0;
  uint8_t count_ = 0;
};

}  // namespace rva_robot

#endif
