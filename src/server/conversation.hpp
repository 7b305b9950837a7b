// The messages of one console's WebSocket (docs/api.md), independent of the socket itself.
#pragma once

#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "server/api.hpp"
#include "server/live_pictures.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// A client violated the protocol: its connection is closed with this reason.
class ProtocolError : public std::exception {
 public:
  explicit ProtocolError(std::string reason) : reason_(std::move(reason)) {}
  [[nodiscard]] const char* what() const noexcept override { return reason_.c_str(); }

 private:
  std::string reason_;
};

/// How a person points at something in the live picture.
enum class PointingShape { tap, arrow, circle };
template <>
inline constexpr auto enum_names<PointingShape> = std::to_array<EnumName<PointingShape>>({
    {PointingShape::tap, "tap"},
    {PointingShape::arrow, "arrow"},
    {PointingShape::circle, "circle"},
});

/// A message of a WebSocket.
struct Message {
  bool binary = false;
  std::string bytes;
};

/// Sends a console only the newest picture and status: one that has not been sent when the next arrives is
/// never sent. A picture is sent only after the console has acknowledged the one before the last, so that a
/// slow connection gets fewer pictures, not older ones. For use by one thread.
class Conversation {
 public:
  static constexpr int protocol = 1;
  static constexpr std::size_t most_message_bytes = 4096;
  static constexpr double most_messages_per_s = 200.0;
  /// How often a person may point at something in the live picture; as many at once as in two seconds.
  static constexpr double most_pointed_per_s = 3.0;

  Conversation(const ServerParts& parts, LivePictures& pictures, Person person);
  ~Conversation();  ///< stops the robot if this was the last connection of the client that drives it
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// @param text one message
  /// @throws ProtocolError when the connection must be closed
  void hear(std::string_view text, double now_s);

  /// What the person has pointed at since the last call, as a message to all consoles; null where nothing.
  [[nodiscard]] std::shared_ptr<const std::string> take_pointed() { return std::exchange(pointed_, nullptr); }

  /// Applies a change of the person's role. A person who may no longer drive loses the controls.
  void set_role(PersonRole role);

  void offer(const std::shared_ptr<const LivePicture>& picture);
  void offer(const std::shared_ptr<const std::string>& status) { status_ = status; }
  /// What somebody has pointed at. The oldest is dropped where a slow connection has not taken the last ones.
  void offer_pointed(const std::shared_ptr<const std::string>& pointed);

  /// The next message to be sent, if any. It counts as sent once this returns.
  [[nodiscard]] std::optional<Message> next(double now_s);

 private:
  void greet(const Json& message);
  void watch(const Json& message);
  void shown(const Json& message);
  void drive(const Json& message, double now_s);
  void lease(const Json& message, double now_s);
  void stop();
  void point(const Json& message, double now_s);
  void limit_rate(double now_s);
  [[nodiscard]] bool is_fresh(double stamp_s, double now_s);
  void refuse(const std::string& code, const std::string& message);
  [[nodiscard]] std::optional<Message> lease_news(double now_s);

  const ServerParts& parts_;
  LivePictures& pictures_;
  Person person_;
  std::string client_;  // empty before its hello
  std::string name_;
  std::optional<Stream> watched_;
  std::shared_ptr<const LivePicture> picture_;  // to be sent
  std::uint64_t sent_ = 0;                      // number of pictures
  std::uint64_t shown_ = 0;
  std::shared_ptr<const std::string> status_;
  std::shared_ptr<const std::string> sent_status_;
  std::string sent_lease_;
  std::deque<std::string> replies_;
  std::shared_ptr<const std::string> pointed_;              // by this person, to be taken
  std::deque<std::shared_ptr<const std::string>> to_show_;  // by others and by this person, to be sent
  double pointing_allowance_ = 2.0 * most_pointed_per_s;
  double pointed_s_ = 0.0;
  double allowance_ = most_messages_per_s;
  double heard_s_ = 0.0;
  std::optional<double> least_delay_s_;  // of drive messages, from the console's clock to the server's
  double stamped_s_ = 0.0;               // time of arrival of the last one
};

}  // namespace rva
