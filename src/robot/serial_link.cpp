#include "robot/serial_link.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <thread>

#include "core/error.hpp"

namespace rva {
namespace {

namespace asio = boost::asio;

constexpr unsigned baud = 115200;
constexpr std::chrono::milliseconds try_again_after{200};
constexpr std::size_t longest_line = 512;  // a device that sends longer lines is not a supported robot

std::string group_of(const std::string& device) {
  struct stat status {};
  if (stat(device.c_str(), &status) != 0) return "dialout";
  const group* const entry = getgrgid(status.st_gid);
  return entry != nullptr ? entry->gr_name : fmt::format("{}", status.st_gid);
}

Error cannot_open(const std::string& device, int error) {
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {device, "no such device",
              "connect the robot, and find its device with: ls /dev/ttyACM* /dev/ttyUSB*"};
    case EACCES:
    case EPERM:
      return {device, "you do not have permission to open it",
              fmt::format("join the group that has it, and log in again: sudo usermod -aG {} $USER",
                          group_of(device))};
    case EBUSY:
    case EWOULDBLOCK:
      return {device, "another program uses it", "close that program (fuser -v shows which)"};
    case ENOTTY:
      return {device, "it is not a serial port", "give the robot's device, such as /dev/ttyACM0"};
    default:
      return {device, std::strerror(error), "unplug the robot, plug it in, and try again"};
  }
}

}  // namespace

class SerialLink::Line {
 public:
  Line(std::string device, Listener listener) : device_(std::move(device)), listener_(std::move(listener)) {
    if (const int error = open(); error != 0) throw cannot_open(device_, error);
  }
  ~Line() {
    io_.stop();
    thread_.join();
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void start() {
    thread_ = std::thread([this] {
      listener_.opened();
      read();
      io_.run();
    });
  }

  void write(std::string bytes) {
    asio::post(io_, [this, bytes = std::move(bytes)]() mutable {
      if (!port_.is_open()) return;
      outgoing_.push_back(std::move(bytes));
      if (outgoing_.size() == 1) write_first();
    });
  }

 private:
  // @return errno, or 0 on success
  int open() {
    const int descriptor = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return errno;
    // TIOCEXCL does not exclude root, and the lock does not exclude programs that do not lock: both
    // are needed.
    if (isatty(descriptor) == 0 || flock(descriptor, LOCK_EX | LOCK_NB) != 0 ||
        ioctl(descriptor, TIOCEXCL) != 0) {
      const int error = errno;
      ::close(descriptor);
      return error;
    }
    try {
      port_.assign(descriptor);
      port_.set_option(asio::serial_port::baud_rate(baud));
      port_.set_option(asio::serial_port::character_size(8));
      port_.set_option(asio::serial_port::parity(asio::serial_port::parity::none));
      port_.set_option(asio::serial_port::stop_bits(asio::serial_port::stop_bits::one));
      port_.set_option(asio::serial_port::flow_control(asio::serial_port::flow_control::none));
    } catch (const boost::system::system_error& error) {
      close();
      return error.code().value();
    }
    return 0;
  }

  void close() {
    boost::system::error_code ignored;  // the device may already be gone
    port_.close(ignored);
    outgoing_.clear();
    incoming_.consume(incoming_.size());
  }

  void read() {
    asio::async_read_until(port_, incoming_, '\n',
                           [this](const boost::system::error_code& error, std::size_t length) {
                             if (error == asio::error::not_found) {  // too long without a line end
                               listener_.on_line({});
                               incoming_.consume(incoming_.size());
                             } else if (error) {
                               lose();
                               return;
                             } else {
                               hand_on(length);
                             }
                             read();
                           });
  }

  void hand_on(std::size_t length) {
    const char* const text = static_cast<const char*>(incoming_.data().data());
    std::size_t end = length - 1;
    while (end > 0 && text[end - 1] == '\r') --end;
    listener_.on_line({text, end});
    incoming_.consume(length);
  }

  void write_first() {
    asio::async_write(port_, asio::buffer(outgoing_.front()),
                      [this](const boost::system::error_code& error, std::size_t) {
                        if (error || outgoing_.empty()) return;  // the read fails as well, and handles it
                        outgoing_.pop_front();
                        if (!outgoing_.empty()) write_first();
                      });
  }

  void lose() {
    if (!port_.is_open()) return;
    close();
    listener_.lost();
    try_again();
  }

  void try_again() {
    timer_.expires_after(try_again_after);
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      if (open() != 0) {
        try_again();
        return;
      }
      listener_.opened();
      read();
    });
  }

  std::string device_;
  Listener listener_;
  asio::io_context io_{1};
  asio::serial_port port_{io_};
  asio::steady_timer timer_{io_};
  asio::streambuf incoming_{longest_line};
  std::deque<std::string> outgoing_;
  std::thread thread_;
};

SerialLink::SerialLink(const std::string& device, Listener listener)
    : line_(std::make_unique<Line>(device, std::move(listener))) {
  line_->start();  // after construction, since listeners may write at once
}

SerialLink::~SerialLink() = default;

void SerialLink::write(std::string bytes) { line_->write(std::move(bytes)); }

}  // namespace rva
