// Ctrl-C during long work: stop between two frames, leave nothing half-written.
#pragma once

#include <exception>

namespace rva {

/// The person asked the program to stop. Not an Error: nothing is wrong. `rva` exits with 128 + the signal.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  [[nodiscard]] int signal() const { return signal_; }
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// From now on SIGINT and SIGTERM are noted for throw_if_interrupted(); a second one ends the process at
/// once.
void note_interrupts();

/// Called between the steps of long work. @throws Interrupted
void throw_if_interrupted();

}  // namespace rva
