#include "tests/firmware/pty_board.hpp"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace rva::test {
namespace {

constexpr double slice_ms = 2.0;
constexpr double most_behind_ms = 100.0;  // a busy machine does not make the board hurry for long

}  // namespace

PtyBoard::PtyBoard(std::string path, MakeFirmware make_firmware, Board::Start start)
    : path_(std::move(path)), make_firmware_(std::move(make_firmware)), board_(make_firmware_(), start) {
  plug_in();
  thread_ = std::thread([this] { run(); });
}

PtyBoard::~PtyBoard() {
  stop_ = true;
  thread_.join();
  unplug();
}

void PtyBoard::unplug() {
  const std::scoped_lock lock(mutex_);
  if (terminal_ < 0) return;
  close(terminal_);
  terminal_ = -1;
  open_ = false;
  std::filesystem::remove(path_);
}

void PtyBoard::plug_in() {
  const std::scoped_lock lock(mutex_);
  terminal_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0)
    throw std::runtime_error("no pseudo terminal");
  termios raw{};
  tcgetattr(terminal_, &raw);
  cfmakeraw(&raw);
  tcsetattr(terminal_, TCSANOW, &raw);
  // Until somebody has opened the other end once, it does not report that nobody has.
  close(open(ptsname(terminal_), O_RDWR | O_NOCTTY));
  std::filesystem::remove(path_);
  std::filesystem::create_symlink(ptsname(terminal_), path_);
}

void PtyBoard::with_board(const std::function<void(Board&)>& work) {
  const std::scoped_lock lock(mutex_);
  work(board_);
}

void PtyBoard::run() {
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  double behind_ms = 0.0;
  while (!stop_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const Clock::time_point now = Clock::now();
    behind_ms =
        std::min(behind_ms + std::chrono::duration<double, std::milli>(now - last).count(), most_behind_ms);
    last = now;
    const std::scoped_lock lock(mutex_);
    follow_opening();
    for (; behind_ms >= slice_ms; behind_ms -= slice_ms) {
      board_.run_ms(slice_ms);
      carry();
    }
  }
}

void PtyBoard::follow_opening() {
  if (terminal_ < 0) return;
  pollfd state{terminal_, POLLOUT, 0};
  poll(&state, 1, 0);
  const bool open = (state.revents & POLLHUP) == 0;
  if (open && !open_) board_.reset(make_firmware_());
  open_ = open;
}

void PtyBoard::carry() {
  const std::string said = board_.take_bytes();
  if (terminal_ < 0 || !open_) return;
  std::array<char, 512> bytes{};
  const ssize_t count = read(terminal_, bytes.data(), bytes.size());
  if (count > 0) board_.send({bytes.data(), static_cast<std::size_t>(count)});
  if (!said.empty()) (void)!write(terminal_, said.data(), said.size());
}

}  // namespace rva::test
