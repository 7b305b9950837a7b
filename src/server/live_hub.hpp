// All consoles that are connected.
#pragma once

#include <list>
#include <memory>

#include "server/asio.hpp"
#include "server/conversation.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// Passes pictures and status on to conversations, and wakes whoever writes them. All members are for the
/// thread of the context, but for what LivePictures calls.
class LiveHub {
 public:
  LiveHub(asio::io_context& context, const ServerParts& parts);

  /// A conversation and its alarm: the timer is cancelled when there may be something to send.
  struct Member {
    Member(asio::io_context& context, const ServerParts& parts, LivePictures& pictures, Person person)
        : conversation(parts, pictures, std::move(person)), alarm(context) {}
    Conversation conversation;
    asio::steady_timer alarm;
    bool ended = false;    ///< nothing more is to be written
    bool written = false;  ///< and nothing is
    bool watched = false;  ///< nobody looks at their rights any more

    void wake() { alarm.cancel(); }
  };

  [[nodiscard]] std::shared_ptr<Member> join(Person person);
  void leave(const std::shared_ptr<Member>& member) { members_.remove(member); }

  /// Ten times a second where it changed, else once: silence tells a console that the line is broken.
  asio::awaitable<void> tell_status();
  /// tell_status() ends soon.
  void end() { ended_ = true; }

 private:
  void tell(const std::shared_ptr<const LivePicture>& picture);

  asio::io_context& context_;
  const ServerParts& parts_;
  std::list<std::shared_ptr<Member>> members_;
  std::shared_ptr<const std::string> status_;
  bool ended_ = false;
  LivePictures pictures_;
};

}  // namespace rva
