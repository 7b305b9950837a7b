// The serial line to a robot: opened, lost and found again in the background.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace rva {

/// Reads lines and writes bytes on a thread of its own. When the device goes away it is opened again, every
/// 200 ms, until it is there.
class SerialLink {
 public:
  /// Called on the link's thread; must not block and must not throw.
  struct Listener {
    std::function<void()> opened;                   ///< each time, before any line
    std::function<void(std::string_view)> on_line;  ///< without its end; empty for what had none
    std::function<void()> lost;
  };

  /// @param device a serial port or a pseudo terminal; 115200 baud, and nobody else's meanwhile
  /// @throws Error when there is no such device, when it may not be opened (it names the group that may),
  /// when
  ///         another program has it, or when it is no serial port
  SerialLink(const std::string& device, Listener listener);
  ~SerialLink();
  SerialLink(const SerialLink&) = delete;
  SerialLink& operator=(const SerialLink&) = delete;

  /// From any thread. What cannot be written, because the device is away, is dropped: the robot would obey it
  /// later, when nobody expects it.
  void write(std::string bytes);

 private:
  class Line;
  std::unique_ptr<Line> line_;
};

}  // namespace rva
