// The queue of lines to the host.
#ifndef RVA_ROBOT_OUTBOX_H
#define RVA_ROBOT_OUTBOX_H

#include <stdint.h>

#include "port.h"

namespace rva_robot {

/// Keeps whole lines until the port has room for them.
class Outbox {
 public:
  static constexpr uint8_t capacity = 192;

  uint8_t room() const { return static_cast<uint8_t>(capacity - size_); }
  /// @return false, without keeping anything, if there is no room for the whole text
  bool put(const char* text, uint8_t length);
  /// Writes as many bytes to the port as it has room for.
  void drain(Port& port);

 private:
  uint8_t bytes_[capacity] = {};
  uint8_t first_ = 0;
  uint8_t size_ = 0;
};

}  // namespace rva_robot

#endif
