// One console's WebSocket, without the socket: what it says, what it is told (docs/api.md).
#pragma once

#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/api.hpp"
#include "server/live_pictures.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// The console says what no console of ours would: the connection ends, with this reason.
class ProtocolError : public std::exception {
 public:
  explicit ProtocolError(std::string reason) : reason_(std::move(reason)) {}
  [[nodiscard]] const char* what() const noexcept override { return reason_.c_str(); }

 private:
  std::string reason_;
};

struct Message {
  bool binary = false;
  std::string bytes;
};

/// Tells a console the newest that there is: a picture or a status that has not been sent when the next one
/// comes is never sent. A picture is sent when the console has said that it shows the one before the last, so
/// that a slow line gets fewer pictures, not older ones. For one thread.
class Conversation {
 public:
  static constexpr int protocol = 1;
  static constexpr std::size_t most_message_bytes = 4096;
  static constexpr double most_messages_per_s = 200.0;

  Conversation(const ServerParts& parts, LivePictures& pictures, Person person);
  ~Conversation();  ///< whoever drove stops
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// @param text one message
  /// @throws ProtocolError when the connection is to end
  void hear(std::string_view text, double now_s);

  /// What the person may do has changed.
  void set_role(PersonRole role);

  void offer(const std::shared_ptr<const LivePicture>& picture);
  void offer(const std::shared_ptr<const std::string>& status) { status_ = status; }

  /// What is to be sent now, if anything; as sent when it returns.
  [[nodiscard]] std::optional<Message> next(double now_s);

 private:
  void greet(const Json& message);
  void watch(const Json& message);
  void shown(const Json& message);
  void drive(const Json& message, double now_s);
  void lease(const Json& message, double now_s);
  void stop();
  void limit_rate(double now_s);
  [[nodiscard]] bool is_fresh(double stamp_s, double now_s);
  void refuse(const std::string& code, const std::string& message);
  [[nodiscard]] std::optional<Message> lease_news(double now_s);

  const ServerParts& parts_;
  LivePictures& pictures_;
  Person person_;
  std::string client_;  // empty before it greeted
  std::string name_;
  std::optional<Stream> watched_;
  std::shared_ptr<const LivePicture> picture_;  // to be sent
  std::uint64_t sent_ = 0;                      // pictures
  std::uint64_t shown_ = 0;
  std::shared_ptr<const std::string> status_;
  std::shared_ptr<const std::string> sent_status_;
  std::string sent_lease_;
  std::deque<std::string> replies_;
  double allowance_ = most_messages_per_s;
  double heard_s_ = 0.0;
  std::optional<double> least_delay_s_;  // of drive messages, by two clocks
  double stamped_s_ = 0.0;               // when the last one came
};

}  // namespace rva
