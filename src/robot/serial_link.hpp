// The serial connection to a robot, which is reopened in the background after a loss.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace rva {

/// Reads lines and writes bytes on a thread of its own. When the device is disconnected, opening it is tried
/// again every 200 ms until it succeeds.
class SerialLink {
 public:
  /// Functions that the link's thread calls. They must not block and must not throw.
  struct Listener {
    std::function<void()> opened;                   ///< each time the device is opened, before any line
    std::function<void(std::string_view)> on_line;  ///< without its line end; empty for input without one
    std::function<void()> lost;                     ///< each time the device is lost
  };

  /// @param device a serial port or a pseudo terminal, opened at 115200 baud for exclusive use
  /// @throws Error when there is no such device, the user lacks permission (the error names the group that
  ///         has it), another program uses it, or it is not a serial port
  SerialLink(const std::string& device, Listener listener);
  ~SerialLink();
  SerialLink(const SerialLink&) = delete;
  SerialLink& operator=(const SerialLink&) = delete;

  /// May be called from any thread. While the device is disconnected, bytes are dropped: later, the robot
  /// would execute them unexpectedly.
  void write(std::string bytes);

 private:
  class Line;
  std::unique_ptr<Line> line_;
};

}  // namespace rva
