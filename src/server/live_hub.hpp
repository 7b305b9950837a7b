// All connected consoles.
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "server/asio.hpp"
#include "server/conversation.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// Passes pictures and status to the conversations, and wakes the coroutines that send them. All members must
/// be called on the thread of the context.
class LiveHub {
 public:
  LiveHub(asio::io_context& context, const ServerParts& parts);

  /// A conversation, and the timers on which its sender, the check of the sender's progress and that of the
  /// person's rights wait. wake() cancels the sender's timer when there may be something to send.
  struct Member {
    Member(asio::io_context& context, const ServerParts& parts, LivePictures& pictures, Person person)
        : conversation(parts, pictures, std::move(person)),
          alarm(context),
          next_look(context),
          next_check(context) {}
    Conversation conversation;
    asio::steady_timer alarm;
    asio::steady_timer next_look;
    asio::steady_timer next_check;
    std::optional<double> writing_since_s;  ///< steady_clock(); only while a message is being sent
    bool ended = false;                     ///< nothing more is to be sent

    void wake() { alarm.cancel(); }
    void end() {
      ended = true;
      alarm.cancel();
      next_look.cancel();
      next_check.cancel();
    }
  };

  [[nodiscard]] std::shared_ptr<Member> join(Person person);
  void leave(const std::shared_ptr<Member>& member) { members_.remove(member); }

  /// Shows all consoles what a member has pointed at since the last call, if anything.
  void pass_on_pointing(Member& member);

  /// Sends the status ten times a second while it changes, and once a second otherwise, so that silence shows
  /// a console that the connection is broken. Runs until end().
  asio::awaitable<void> tell_status();
  /// Ends tell_status() soon afterwards.
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
