// A board on a pseudo terminal, in real time: a robot that is not there.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "tests/firmware/board.hpp"

namespace rva::test {

/// Opening the terminal resets the board, as it does a real one.
class PtyBoard {
 public:
  using MakeFirmware = std::function<std::unique_ptr<Firmware>()>;
  /// @param path of the link to the terminal, where it stays when it is unplugged and comes back
  PtyBoard(std::string path, MakeFirmware make_firmware, Board::Start start = {0.0, -10.0, true});
  ~PtyBoard();
  PtyBoard(const PtyBoard&) = delete;
  PtyBoard& operator=(const PtyBoard&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  void unplug();
  void plug_in();

  /// While nothing runs on the board.
  void with_board(const std::function<void(Board&)>& work);

 private:
  void run();
  void carry();
  void follow_opening();

  std::string path_;
  MakeFirmware make_firmware_;
  std::mutex mutex_;  // guards all below
  Board board_;
  int terminal_ = -1;
  bool open_ = false;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace rva::test
