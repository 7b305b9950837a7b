// Where bytes go.
#ifndef RVA_ROBOT_PORT_H
#define RVA_ROBOT_PORT_H

#include <stdint.h>

namespace rva_robot {

/// Never waits.
class Port {
 public:
  /// Bytes that can be written now.
  virtual uint8_t room() const = 0;
  /// No more than room().
  virtual void write(const uint8_t* bytes, uint8_t count) = 0;

 protected:
  ~Port() = default;
};

}  // namespace rva_robot

#endif
