// Lines on their way to the host.
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
  /// @return false, with nothing kept, where there is no room for all of it
  bool put(const char* text, uint8_t length);
  /// Gives the port what it can take.
  void drain(Port& port);

 private:
  uint8_t bytes_[capacity] = {};
  uint8_t first_ = 0;
  uint8_t size_ = 0;
};

}  // namespace rva_robot

#endif
