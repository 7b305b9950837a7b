// Ctrl-C during long work: stop between two frames, leave nothing half-written.
#pragma once

#include <exception>

namespace rva {

/// The user asked the program to stop. Not an Error: nothing is wrong. `rva` exits with 128 + the signal.
class Interrupted : public std::exception {
 public:
  /// @param signal number of the signal; 0 if the work was cancelled without one
  explicit Interrupted(int signal) : signal_(signal) {}
  /// Number of the signal; 0 if the work was cancelled without one.
  [[nodiscard]] int signal() const { return signal_; }
  /// "interrupted".
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// From now on, SIGINT and SIGTERM are noted for throw_if_interrupted(). A second signal ends the process
/// at once.
void note_interrupts();

/// To be called between the steps of long work. @throws Interrupted when a signal has been noted
void throw_if_interrupted();

}  // namespace rva
