// The output of a serial line.
#ifndef RVA_ROBOT_PORT_H
#define RVA_ROBOT_PORT_H

#include <stdint.h>

namespace rva_robot {

/// A serial line that never blocks.
class Port {
 public:
  /// Number of bytes that can be written now.
  virtual uint8_t room() const = 0;
  /// @param count at most room()
  virtual void write(const uint8_t* bytes, uint8_t count) = 0;

 protected:
  ~Port() = default;
};

}  // namespace rva_robot

#endif
